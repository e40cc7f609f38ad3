// Time series as CSV text: one header line with names and units, then one row per sample.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// Heading of a column, written `name [unit]` and without the brackets where the unit is empty.
struct TableColumn {
  std::string name;
  std::string unit;
};

/// Writes a table row by row. Every row is handed to the operating system at once, so a killed run
/// loses at most the row being written. Numbers are the shortest decimals that read back to the
/// same double. Names with commas or quotes are quoted as in RFC 4180, section 2.
class TableCsv {
 public:
  /// Starts a new file (an old one is replaced; missing folders are made).
  /// Throws OutputError if it cannot be written.
  TableCsv(std::filesystem::path path, std::vector<TableColumn> columns);

  /// Goes on with a file as it was when it had `size` bytes; rows behind that are cut off. Throws
  /// OutputError if the file is shorter or cannot be written.
  TableCsv(std::filesystem::path path, std::vector<TableColumn> columns, std::uint64_t size);

  /// Appends one row. Throws std::invalid_argument if the number of values is not the number of
  /// columns, OutputError if writing fails (disk full).
  void add(std::span<double const> row);

  std::span<TableColumn const> columns() const { return columns_; }
  std::filesystem::path const& path() const { return path_; }
  std::uint64_t size() const { return size_; }  // bytes written

 private:
  void write_line();

  std::filesystem::path path_;
  std::vector<TableColumn> columns_;
  std::ofstream stream_;
  std::uint64_t size_ = 0;
  std::string line_;  // kept to avoid allocation per row
};

/// A table in memory, by column.
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<double>> values;  // [column][row]

  std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }

  /// Values of the column with this name, or nullptr.
  std::vector<double> const* find(std::string_view name) const;
};

/// A text as a field of such a file: quoted as in RFC 4180, section 2, where it needs to be.
std::string csv_field(std::string_view text);

/// A table as TableCsv writes it: the shortest decimals that read back to the same double.
std::string csv_text(Table const& table);

/// Writes it, complete or not at all; throws OutputError.
void write_csv(Table const& table, std::filesystem::path const& path);

/// Reads what TableCsv writes. An incomplete last line (from a killed run) is left out.
/// Throws std::runtime_error naming file and line for a missing file, a missing header or a field
/// that is not a number.
Table read_table_csv(std::filesystem::path const& path);

}  // namespace moraine
