#include "output/table_csv.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "output/atomic_file.hpp"
#include "output/output_error.hpp"

namespace moraine {
namespace {

std::string heading(TableColumn const& column) {
  return csv_field(column.unit.empty() ? column.name
                                       : fmt::format("{} [{}]", column.name, column.unit));
}

TableColumn parse_heading(std::string const& text) {
  std::size_t const open = text.rfind(" [");
  if (open == std::string::npos || text.back() != ']') return {text, ""};
  return {text.substr(0, open), text.substr(open + 2, text.size() - open - 3)};
}

std::vector<std::string> split_header(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    char const c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

/// Appends the numbers of a line to `row`; false where a field is not a number.
bool parse_row(std::string_view line, std::vector<double>& row) {
  row.clear();
  char const* at = line.data();
  char const* const end = at + line.size();
  while (true) {
    double value = 0.0;
    auto const [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || (next != end && *next != ',')) return false;
    row.push_back(value);
    if (next == end) return true;
    at = next + 1;
  }
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (char const c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

TableCsv::TableCsv(std::filesystem::path path, std::vector<TableColumn> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {
  std::error_code ignored;  // a folder that could not be made shows when the file is opened
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), ignored);
  stream_.open(path_, std::ios::binary | std::ios::trunc);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (i > 0) line_ += ',';
    line_ += heading(columns_[i]);
  }
  write_line();
}

TableCsv::TableCsv(std::filesystem::path path, std::vector<TableColumn> columns, std::uint64_t size)
    : path_(std::move(path)), columns_(std::move(columns)), size_(size) {
  std::error_code error;
  auto const found = std::filesystem::file_size(path_, error);
  if (error || found < size)
    throw OutputError(
        fmt::format("'{}' is missing or shorter than it was at the checkpoint", path_.string()));
  std::filesystem::resize_file(path_, size, error);
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (error || !stream_) throw OutputError(fmt::format("cannot go on with '{}'", path_.string()));
}

void TableCsv::add(std::span<double const> row) {
  if (row.size() != columns_.size())
    throw std::invalid_argument(fmt::format("{}: a row of {} values for {} columns", path_.string(),
                                            row.size(), columns_.size()));
  line_.clear();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) line_ += ',';
    fmt::format_to(std::back_inserter(line_), "{}", row[i]);
  }
  write_line();
}

void TableCsv::write_line() {
  line_ += '\n';
  errno = 0;
  stream_.write(line_.data(), static_cast<std::streamsize>(line_.size())).flush();
  if (!stream_)
    throw OutputError(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)));
  size_ += line_.size();
}

std::vector<double> const* Table::find(std::string_view name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return &values[i];
  return nullptr;
}

std::string csv_text(Table const& table) {
  std::string text;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    text += fmt::format("{}{}", k > 0 ? "," : "", heading(table.columns[k]));
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{}{}", k > 0 ? "," : "", table.values[k][row]);
    text += '\n';
  }
  return text;
}

void write_csv(Table const& table, std::filesystem::path const& path) {
  AtomicFile file(path);
  file.stream() << csv_text(table);
  file.commit();
}

Table read_table_csv(std::filesystem::path const& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("cannot read table '{}'", path.string()));
  std::string line;
  if (!std::getline(stream, line) || line.empty())
    throw std::runtime_error(fmt::format("table '{}' has no header line", path.string()));
  if (line.back() == '\r') line.pop_back();
  Table table;
  for (std::string const& field : split_header(line)) table.columns.push_back(parse_heading(field));
  table.values.resize(table.columns.size());

  std::vector<double> row;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (stream.eof()) break;  // no line end: the row was not finished
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!parse_row(line, row) || row.size() != table.columns.size())
      throw std::runtime_error(fmt::format("{}:{}: expected {} numbers, found '{}'", path.string(),
                                           number, table.columns.size(), line));
    for (std::size_t i = 0; i < row.size(); ++i) table.values[i].push_back(row[i]);
  }
  return table;
}

}  // namespace moraine
