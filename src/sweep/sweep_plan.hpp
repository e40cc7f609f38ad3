// What a sweep file says: which keys of a case take which values, and what is taken from each run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "setup/source.hpp"
#include "sweep/case_key.hpp"
#include "sweep/draws.hpp"
#include "sweep/sweep_output.hpp"

namespace moraine {

/// `grid`: every value with every other. `list`: the first values together, then the second ones
/// ... `latin_hypercube`: drawn from the ranges.
enum class SweepMethod : std::uint8_t { grid, list, latin_hypercube };

/// A value of a key: as TOML, as a number in SI or a text, and where the sweep file says so.
struct SweepValue {
  std::string toml;
  std::variant<double, std::string> shown;
  Stretch place;
};

/// A key that varies: a column of the table.
struct SweepColumn {
  CaseKey key;
  std::string label;
  std::string unit;  // SI; empty for texts and plain numbers
};

/// Keys that change together, and their values.
struct SweepAxis {
  std::vector<SweepColumn> columns;
  std::vector<std::vector<SweepValue>> values;  // [value][column]; empty where they are drawn
  std::optional<ValueRange> range;
  Stretch range_place;
  bool logarithmic = false;  // of ranges, and of plots

  bool varies() const { return values.size() != 1; }
};

/// The values of all columns of an axis for a number out of its range; whole numbers are rounded.
std::vector<SweepValue> values_of(SweepAxis const& axis, double number);

struct SweepMember {
  std::string name;                // "003-wendland_c2", also of its folder
  std::vector<SweepValue> values;  // of all columns
};

struct SweepPlan {
  std::string title;
  std::filesystem::path case_file;
  SweepMethod method = SweepMethod::grid;
  int at_once = 1;
  std::optional<int> samples;
  int seed = 1;
  std::vector<SweepAxis> axes;
  std::vector<SweepOutput> outputs;
  std::vector<SweepMember> members;

  std::vector<SweepColumn> columns() const;
};

inline constexpr std::size_t most_members = 10000;

}  // namespace moraine
