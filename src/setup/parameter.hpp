// A parameter of the case file as data: what the parser, the messages, `explain`, the JSON schema
// and the reference page know about a key. No Case is needed to read it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/units.hpp"

namespace moraine {

/// What stands behind a key. Numbers of a quantity may be a plain SI number or a text with unit.
enum class ValueType : std::uint8_t {
  integer,
  real,       // a number of the parameter's quantity
  reals,      // a list of such numbers
  vector,     // exactly `dimension` such numbers
  text,       // not empty
  choice,     // one of `names`
  axes,       // a list of axis names; those of the case's dimension are valid
  side,       // one of the side names, "x-" ... "z+"
  sides,      // a list of side names
  texts,      // a list of texts, none of them empty; of `names` where there are any
  corners,    // a list of pairs of such numbers, whatever the dimension
  points,     // a list of vectors of such numbers, with as many components as the dimension
  shapes,     // a list of tables, each with the keys of shape_entries(); read and written apart
  shape_key,  // not a key itself: exactly one of the keys `names` must be present in the table
};

/// A value while it travels between file and Case: nothing, number, integer or index into the
/// names, text, three components, list (of corners: x, y, x, y ...; of points: x, y, z, x ...),
/// list of indices, list of texts. Always in SI.
using Value = std::variant<std::monostate, double, int, std::string, std::array<double, 3>,
                           std::vector<double>, std::vector<int>, std::vector<std::string>>;

/// Valid range of a number or of every component. NaN is never valid; infinity only on request:
/// plus where there is a least value, else minus.
struct Limits {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_excluded = false;
  bool infinity_allowed = false;

  static constexpr Limits none() { return {}; }
  static constexpr Limits positive() { return {.min = 0.0, .min_excluded = true}; }
  static constexpr Limits not_negative() { return {.min = 0.0}; }
  static constexpr Limits between(double low, double high) { return {.min = low, .max = high}; }
};

/// The tables of a case file. A `list` is written [[region]], a `named` table [material.NAME].
enum class Section : std::uint8_t { top, material, region, wall, gauge, stage, reference };
inline constexpr std::size_t section_count = 7;
enum class Repeat : std::uint8_t { once, named, list };

struct SectionInfo {
  Section section;
  std::string_view key;  // empty for the top level
  Repeat repeat;
  std::string_view meaning;
  bool needed = false;  // a case has at least one
};

inline constexpr std::array<SectionInfo, section_count> section_table{{
    {Section::top, "", Repeat::once, "the case itself"},
    {Section::material, "material", Repeat::named, "a material: equation of state and constants",
     true},
    {Section::region, "region", Repeat::list,
     "particles of one material on the lattice points of a shape; later regions replace earlier; a "
     "case that starts from another run needs none"},
    {Section::wall, "wall", Repeat::list,
     "a rigid wall, at rest or moved as prescribed: the faces of a box"},
    {Section::gauge, "gauge", Repeat::list, "something measured during the run"},
    {Section::stage, "stage", Repeat::list, "a part of the run; stages follow each other"},
    {Section::reference, "reference", Repeat::list,
     "a measured or exact value or curve that reports show beside the readings of a gauge"},
}};

constexpr SectionInfo const& info(Section section) {
  return section_table[static_cast<std::size_t>(section)];
}

/// Whether a key must be given. `with_table`: only if its own sub-table is there at all.
enum class Presence : std::uint8_t { required, with_table, optional };

/// One entry of the table of parameters.
struct Parameter {
  Section section = Section::top;
  std::string_view key{};  // inside its section, dotted: "space.domain.min"
  ValueType type = ValueType::real;
  Quantity quantity = Quantity::number;
  Presence presence = Presence::optional;
  Value preset{};                  // default; monostate: none
  std::string_view preset_note{};  // how an absent value is found, where it is no constant
  Limits limits{};
  std::vector<std::string_view>
      names{};  // of a choice, in the order of the enum that it sets; of texts
  // The key exists only where the choice or shape key `when_key` has the value `when_value`.
  std::string_view when_key{};
  std::string_view when_value{};
  // Must be given where this other key of the table is not; a check of its own says so.
  std::string_view unless_key{};
  std::string_view meaning{};  // one line
  std::string_view source{};   // of the default or of the constant; may be empty
  // A choice that decides another choice `decides` too: to `decided[i]` where names[i] is given.
  // That other key is then refused, and the keys that depend on it may be left out.
  std::string_view decides{};
  std::vector<std::string_view> decided{};
};

/// Names of axes and sides in the order of their indices: axis, 2 axis + (0 minus | 1 plus).
inline constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};
inline constexpr std::array<std::string_view, 6> side_names{"x-", "x+", "y-", "y+", "z-", "z+"};

/// "material.NAME.reference_density", "region[].velocity", "time.end".
std::string full_key(Parameter const& parameter);

/// A Value as TOML, numbers in SI: shortest text that reads back to the same bits.
/// Vectors show their first `dimension` components. Empty text for monostate.
std::string to_toml(Value const& value, Parameter const& parameter, int dimension);

}  // namespace moraine
