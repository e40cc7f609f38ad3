#include "setup/motion_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace moraine {
namespace {

constexpr std::array<std::string_view, 5> known_columns{"time", "x", "y", "z", "angle"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  auto const first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    auto const comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// The columns of a motion file by the place of their names in known_columns.
class Columns {
 public:
  explicit Columns(int dimension) : dimension_(dimension) {}

  void add_line(std::string_view line, std::size_t number) {
    auto const cells = cells_of(line);
    if (order_.empty()) return read_names(cells, number);
    if (cells.size() != order_.size())
      throw MotionFileError(fmt::format("line {} has {} columns; {} are named above", number,
                                        cells.size(), order_.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      double value = 0.0;
      std::string_view number_text = cells[k];
      if (number_text.starts_with('+')) number_text.remove_prefix(1);
      auto const* const last = number_text.data() + number_text.size();
      auto const [end, error] = std::from_chars(number_text.data(), last, value);
      if (error != std::errc{} || end != last)
        throw MotionFileError(fmt::format("line {}: \"{}\" is not a number", number, cells[k]));
      values_[order_[k]].push_back(value);
    }
  }

  FiledMotion motion() const {
    if (order_.empty()) throw MotionFileError("is empty");
    FiledMotion result;
    for (std::size_t axis = 0; axis < 3; ++axis) result.motion.translation[axis] = course(1 + axis);
    result.motion.rotation = course(4);
    result.end = values_[0].back();
    return result;
  }

 private:
  void read_names(std::vector<std::string_view> const& names, std::size_t number) {
    for (auto const name : names) {
      auto const found = std::find(known_columns.begin(), known_columns.end(), name);
      auto const column = static_cast<std::size_t>(found - known_columns.begin());
      bool const useless =
          (column >= 1 && column <= 3 && column > static_cast<std::size_t>(dimension_)) ||
          (column == 4 && dimension_ == 1);
      if (found == known_columns.end() || useless)
        throw MotionFileError(fmt::format(
            "line {}: \"{}\" is no column of a motion in {}D; time, x, y, z and angle are{}",
            number, name, dimension_,
            name.find_first_of(";\t") == std::string_view::npos ? "" : ", separated by commas"));
      if (std::find(order_.begin(), order_.end(), column) != order_.end())
        throw MotionFileError(fmt::format("line {}: \"{}\" is named twice", number, name));
      order_.push_back(column);
    }
    if (std::find(order_.begin(), order_.end(), std::size_t{0}) == order_.end() ||
        order_.size() < 2)
      throw MotionFileError(
          fmt::format("line {} must name the column time and at least one more", number));
  }

  TimeCourse course(std::size_t column) const {
    if (std::find(order_.begin(), order_.end(), column) == order_.end()) return {};
    try {
      return TimeCourse::table(values_[0], values_[column]);
    } catch (std::invalid_argument const& error) {
      throw MotionFileError(error.what());
    }
  }

  int dimension_;
  std::vector<std::size_t> order_;  // of the columns in the file
  std::array<std::vector<double>, known_columns.size()> values_;
};

}  // namespace

FiledMotion read_motion_file(std::filesystem::path const& path, int dimension) {
  constexpr std::uintmax_t most_bytes = 100'000'000;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw MotionFileError("does not exist");
  if (!std::filesystem::is_regular_file(path, error)) throw MotionFileError("is not a file");
  if (std::filesystem::file_size(path, error) > most_bytes)
    throw MotionFileError(fmt::format("is larger than {} bytes", most_bytes));
  std::ifstream file(path);
  if (!file) throw MotionFileError("cannot be read");
  Columns columns(dimension);
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::string_view text = line;
    if (number == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // of spreadsheets
    text = trimmed(text);
    if (!text.empty() && text.front() != '#') columns.add_line(text, number);
  }
  return columns.motion();
}

}  // namespace moraine
