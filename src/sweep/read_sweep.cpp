#include "sweep/read_sweep.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "setup/table_reader.hpp"
#include "setup/value_reader.hpp"
#include "sweep/check_members.hpp"
#include "sweep/make_members.hpp"
#include "sweep/read_axis.hpp"
#include "sweep/read_output.hpp"
#include "sweep/sweep_tables.hpp"

namespace moraine {
namespace {

constexpr std::array<std::string_view, 2> list_names{"parameter", "output"};

[[noreturn]] void refuse(std::filesystem::path const& file, std::string rule) {
  throw InputErrors({{file.string(), 0, 0, "", "", std::move(rule), ""}});
}

std::string text_of(std::filesystem::path const& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse(file, "is a folder, not a sweep file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    refuse(file, errno == ENOENT ? "does not exist"
                                 : fmt::format("cannot be read: {}", std::strerror(errno)));
  return {std::istreambuf_iterator<char>(stream), {}};
}

toml::table parse(std::string const& text, std::string const& file) {
  try {
    return toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    auto const place = error.source().begin;
    throw InputErrors(
        {{file, place.line, place.column, "", "", std::string(error.description()), ""}});
  }
}

class SweepReader {
 public:
  SweepReader(std::filesystem::path const& file, std::string const& text)
      : folder_(file.parent_path()),
        root_(parse(text, file.string())),
        source_(text, file.string()) {}

  Sweep read() {
    int const dimension = 0;
    read_table(TableReader(root_, "", source_), sweep_head_entries(), head_, dimension, list_names);
    check_head();
    read_template();
    if (!cases_) stop();
    plan_.title = head_.title.empty() ? source_.file() : head_.title;
    plan_.method = head_.method;
    plan_.at_once = head_.at_once;
    plan_.samples = head_.samples;
    plan_.seed = head_.seed.value_or(1);
    read_axes();
    read_outputs();
    check_numbers_of_values();
    add_members();
    stop();
    return {std::move(plan_), std::move(*cases_)};
  }

 private:
  void stop() const {
    auto problems = source_.problems();
    problems.insert(problems.end(), elsewhere_.begin(), elsewhere_.end());
    if (!problems.empty()) throw InputErrors(std::move(problems));
  }

  void check_head() {
    bool const drawn = head_.method == SweepMethod::latin_hypercube;
    if (!source_.good("method")) return;
    if (drawn && !source_.has("samples"))
      source_.report_key("samples", source_.place_of("method"),
                         "is missing: how many members a latin hypercube has");
    for (char const* key : {"samples", "seed"})
      if (!drawn && source_.has(key))
        source_.report_value(key, "belongs to method = \"latin_hypercube\"", "leave it out");
  }

  void read_template() {
    if (head_.case_file.empty()) return;
    std::filesystem::path file = head_.case_file;
    if (file.is_relative()) file = folder_ / file;
    plan_.case_file = file.lexically_normal();
    try {
      cases_.emplace(plan_.case_file);
    } catch (InputErrors const& errors) {
      elsewhere_ = errors.problems();
      bool const unreadable = elsewhere_.size() == 1 && elsewhere_.front().key.empty();
      if (!unreadable || elsewhere_.front().line > 0) return;
      source_.report_value("case", elsewhere_.front().rule, elsewhere_.front().hint);
      elsewhere_.clear();
    }
  }

  toml::array const* list(char const* name) {
    auto const* node = root_.get(name);
    if (node == nullptr) return nullptr;
    if (auto const* array = node->as_array()) return array;
    source_.report_key(name, stretch_of(node->source()), "is not a table of this kind",
                       fmt::format("write [[{}]]", name));
    return nullptr;
  }

  template <class Read>
  void read_list(char const* name, Read read) {
    auto const* items = list(name);
    if (items == nullptr) return;
    std::size_t number = 0;
    for (auto const& item : *items) {
      std::string const key = fmt::format("{}[{}]", name, ++number);
      if (auto const* table = item.as_table())
        read(*table, key + '.');
      else
        source_.report_key(key, stretch_of(item.source()), "is not a table of this kind",
                           fmt::format("write [[{}]]", name));
    }
  }

  void read_axes() {
    if (!root_.contains("parameter"))
      source_.report_key("parameter", {}, "is missing: what the sweep varies",
                         "write [[parameter]]");
    AxisContext const context{cases_->base(),
                              source_.good("method") ? std::optional(head_.method) : std::nullopt};
    read_list("parameter", [&](toml::table const& table, std::string const& prefix) {
      if (auto axis = read_axis(table, prefix, context, source_)) {
        if (is_new(*axis, table, prefix)) plan_.axes.push_back(std::move(*axis));
      } else {
        whole_ = false;
      }
    });
  }

  /// Keys and labels are there once. Only a key that is there twice makes the parameter useless.
  bool is_new(SweepAxis const& axis, toml::table const& table, std::string const& prefix) {
    std::string const key = prefix.substr(0, prefix.size() - 1);
    auto const wrong = [&](std::string rule, std::string hint) {
      source_.report_key(key, stretch_of(table.source()), std::move(rule), std::move(hint));
    };
    for (SweepColumn const& column : axis.columns) {
      if (!keys_.insert(column.key.path).second) {
        wrong(fmt::format("varies {} a second time", column.key.path), "");
        return false;
      }
      if (!labels_.insert(column.label).second)
        wrong(fmt::format("has the label \"{}\" of another", column.label),
              "give it a label of its own");
    }
    return true;
  }

  void read_outputs() {
    bool const arrivals = cases_->base().output.arrival_pressure.has_value() ||
                          keys_.contains("output.arrival_pressure");
    OutputContext const context{cases_->base(), arrivals};
    read_list("output", [&](toml::table const& table, std::string const& prefix) {
      auto output = read_output(table, prefix, context, source_);
      if (!output) return;
      if (!labels_.insert(output->label).second)
        source_.report_key(prefix.substr(0, prefix.size() - 1), stretch_of(table.source()),
                           fmt::format("has the label \"{}\" of another", output->label),
                           "give it a label of its own");
      plan_.outputs.push_back(std::move(*output));
    });
  }

  void check_numbers_of_values() {
    if (head_.method != SweepMethod::list) return;
    std::size_t const most = count_members(plan_);
    for (SweepAxis const& axis : plan_.axes)
      if (axis.varies() && axis.values.size() != most)
        source_.report_key(
            axis.columns.front().key.path, axis.values.front().front().place,
            fmt::format("has {} values where another parameter has {}", axis.values.size(), most),
            "a list takes the first values together, then the second ones ...; "
            "one value counts for all");
  }

  /// Members of a plan from which wrong parameters are left out still show the mistakes of the
  /// others.
  void add_members() {
    if (plan_.axes.empty() || !source_.good("method") || source_.has_problem("samples")) return;
    for (SweepAxis const& axis : plan_.axes)
      if (source_.has_problem(axis.columns.front().key.path) && head_.method == SweepMethod::list)
        return;
    std::size_t const count = count_members(plan_);
    if (count > most_members) {
      source_.report_key("parameter", {}, "makes too many members",
                         fmt::format("at most {} are possible", most_members));
      return;
    }
    plan_.members = make_members(plan_);
    auto const more = check_members(plan_, *cases_, source_);
    if (whole_) elsewhere_.insert(elsewhere_.end(), more.begin(), more.end());
  }

  std::filesystem::path folder_;
  toml::table root_;
  Source source_;
  SweepHead head_;
  SweepPlan plan_;
  std::optional<CaseTemplate> cases_;
  std::vector<InputProblem> elsewhere_;
  std::set<std::string> keys_;
  std::set<std::string> labels_;
  bool whole_ = true;  // no parameter was left out
};

}  // namespace

Sweep read_sweep(std::filesystem::path const& file) {
  std::string const text = text_of(file);
  return SweepReader(file, text).read();
}

std::vector<Replacement> replacements_of(SweepPlan const& plan, SweepMember const& member) {
  std::vector<Replacement> replacements;
  auto const columns = plan.columns();
  for (std::size_t i = 0; i < columns.size(); ++i)
    replacements.push_back({columns[i].key, member.values[i].toml});
  return replacements;
}

}  // namespace moraine
