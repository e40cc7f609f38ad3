// What the readers of several kinds of gauges share.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "output/table_csv.hpp"
#include "probes/selection.hpp"
#include "setup/case.hpp"
#include "store/particle_store.hpp"

namespace moraine {

inline constexpr std::array axis_letter{'x', 'y', 'z'};

/// A column for each axis: name_x, name_y ...
void add_vector_columns(std::vector<TableColumn>& columns, std::string const& name, int dimension,
                        std::string const& unit);

/// The number of a material that the case has.
MaterialId material_of(Case const& c, std::string const& name);

/// What a gauge looks at: its materials and its box.
Selection selection_of(Case const& c, GaugeSpec const& gauge);

/// The direction that the heights of a gauge are counted in; there is one in a case that is good.
Upwards up_of(Case const& c, GaugeSpec const& gauge);

/// Unit of a length to this power: none for 0.
std::string unit_of_length(int power);

}  // namespace moraine
