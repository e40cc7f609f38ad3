// Reads one table of a case file by the table of parameters.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setup/binding.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"

namespace moraine {

/// One TOML table, its full key, and the choices made in it so far.
class TableReader {
 public:
  /// `prefix` is the full key of the table with a dot behind it, empty at the top.
  TableReader(toml::table const& table, std::string prefix, Source& source)
      : table_(table), prefix_(std::move(prefix)), source_(source) {}

  /// Whether the parameter exists in this table after the choices made so far.
  bool applies(Parameter const& parameter) const;

  /// The value from the file, or the default, or nothing. Mistakes are reported.
  std::optional<Value> read(Parameter const& parameter, int dimension);

  /// Reports keys that are no parameters; `others` are further valid keys of this table.
  void check_keys(std::vector<Parameter const*> const& parameters,
                  std::span<std::string_view const> others);

 private:
  // Applies, or might do so: its choice is missing or wrong, then every alternative passes.
  bool is_possible(Parameter const& parameter) const;
  std::optional<Value> read_shape_key(Parameter const& parameter);
  void decide(Parameter const& parameter, std::optional<Value> const& value);
  std::optional<Value> absent(Parameter const& parameter);
  void check_keys_in(toml::table const& table, std::string const& path,
                     std::vector<Parameter const*> const& parameters,
                     std::span<std::string_view const> others);
  void report_unknown(toml::key const& key, std::string const& path,
                      std::vector<Parameter const*> const& parameters,
                      std::span<std::string_view const> others);

  toml::table const& table_;
  std::string prefix_;
  Source& source_;
  std::map<std::string_view, std::string_view> chosen_;   // choice key -> name
  std::map<std::string_view, std::string_view> decided_;  // choice key -> the key that decided it
  std::map<std::string_view, std::string_view> instead_;  // choice key -> a key that could have
};

/// Reads all entries of a table into `target` and reports unknown keys. `dimension` is read anew
/// for every value, since it may be one of the entries.
template <class Target>
void read_table(TableReader reader, std::span<Entry<Target> const> entries, Target& target,
                int const& dimension, std::span<std::string_view const> others = {}) {
  std::vector<Parameter const*> parameters;
  for (auto const& entry : entries) {
    parameters.push_back(&entry.parameter);
    if (!reader.applies(entry.parameter)) continue;
    if (auto const value = reader.read(entry.parameter, dimension)) entry.set(target, *value);
  }
  reader.check_keys(parameters, others);
}

}  // namespace moraine
