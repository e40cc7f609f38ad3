// The table of parameters: shapes, of a region itself and of the items of `plus` and `minus`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setup/binding.hpp"
#include "setup/shape/shape.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"

namespace moraine {

/// Adds the keys of a shape to the table of a Target with the members shape, plus and minus:
/// RegionSpec or ShapeTree.
template <class Target>
void add_shape_entries(std::vector<Entry<Target>>& table, Section section);

/// The keys of one item of `plus` or `minus`.
std::span<Entry<ShapeTree> const> shape_entries();

/// Reads the lists `plus` and `minus` of a table, whose full key with a dot behind it is `prefix`,
/// and the lists inside them. Items are named "region.pool.minus[1]". What the lists are not is
/// reported by the table of parameters.
template <class Target>
void read_shape_lists(toml::table const& table, std::string const& prefix, Target& target,
                      int const& dimension, Source& source);

/// The lists `plus` and `minus` as lines of TOML in SI units; empty without them.
template <class Target>
std::string shape_lists_text(Target const& target, int dimension);

}  // namespace moraine
