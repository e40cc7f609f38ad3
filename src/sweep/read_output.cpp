#include "sweep/read_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "output/gauge_reader.hpp"
#include "output/run_recorder.hpp"
#include "setup/table_reader.hpp"
#include "setup/value_reader.hpp"
#include "sweep/sweep_tables.hpp"

namespace moraine {
namespace {

class OutputReader {
 public:
  OutputReader(toml::table const& table, std::string const& prefix, OutputContext const& context,
               Source& source)
      : table_(table), prefix_(prefix), context_(context), source_(source) {}

  std::optional<SweepOutput> read() {
    read_table(TableReader(table_, prefix_, source_), output_entries(), head_,
               context_.base.dimension);
    int const sources = has("gauge") + has("sums") + has("run");
    if (sources != 1)
      wrong_table(sources == 0 ? "needs one of gauge, sums or run"
                               : "has several of gauge, sums and run; only one is possible");
    else if (has("run"))
      read_run();
    else
      read_series();
    for (char const* key : {"gauge", "sums", "run", "column", "measure", "label"})
      good_ = good_ && !source_.has_problem(prefix_ + key);
    if (!good_) return std::nullopt;
    if (!head_.label.empty()) output_.label = head_.label;
    return output_;
  }

 private:
  bool has(char const* key) const { return table_.contains(key); }

  void wrong(char const* key, std::string rule, std::string hint = {}) {
    source_.report_value(prefix_ + key, std::move(rule), std::move(hint));
    good_ = false;
  }

  void wrong_table(std::string rule, std::string hint = {}) {
    source_.report_key(prefix_.substr(0, prefix_.size() - 1), stretch_of(table_.source()),
                       std::move(rule), std::move(hint));
    good_ = false;
  }

  void read_run() {
    output_.from = OutputSource::run;
    output_.number = head_.run;
    output_.unit = unit_of(head_.run);
    output_.label = run_number_names[static_cast<std::size_t>(head_.run)];
    for (char const* key : {"column", "measure"})
      if (has(key)) wrong(key, "does not belong to a number of the run", "leave it out");
  }

  void read_series() {
    output_.from = has("gauge") ? OutputSource::gauge : OutputSource::sums;
    output_.measure = head_.measure;
    if (!has("measure"))
      wrong_table("needs a measure: what is taken of the readings", name_hint("", measure_names));
    if (source_.has_problem(prefix_ + (has("gauge") ? "gauge" : "sums"))) return;
    auto const column = has("gauge") ? column_of_gauge() : column_of_sums();
    if (!column || !good_) return;
    check_measure(*column);
    output_.column = column->name;
    output_.unit = unit_of(head_.measure, column->unit);
    std::string measure(measure_names[static_cast<std::size_t>(head_.measure)]);
    std::replace(measure.begin(), measure.end(), '_', ' ');
    output_.label = fmt::format("{} {}", column->name, measure);
  }

  std::optional<TableColumn> column_of_gauge() {
    output_.gauge = head_.gauge;
    std::vector<std::string_view> names;
    for (GaugeSpec const& gauge : context_.base.gauges) {
      names.push_back(gauge.name);
      if (gauge.name == head_.gauge) return column_of(make_gauge_reader(context_.base, gauge));
    }
    wrong("gauge", "is no gauge of the case", name_hint(head_.gauge, names));
    return std::nullopt;
  }

  std::optional<TableColumn> column_of(GaugeReader const& reader) {
    if (head_.measure == Measure::decay_exponent) return decay_of(reader);
    if (!has("column") && reader.columns.size() == 1) return reader.columns.front();
    std::vector<std::string> names;
    for (TableColumn const& column : reader.columns) {
      std::string name = column.name.substr(reader.name.size());
      if (name.starts_with(' ')) name.erase(0, 1);
      if (has("column") && name == head_.column) return column;
      names.push_back(std::move(name));
    }
    std::vector<std::string_view> const known(names.begin(), names.end());
    if (!has("column"))
      wrong_table("needs a column of the gauge", name_hint("", known));
    else if (!source_.has_problem(prefix_ + "column"))
      wrong("column", "is no column of this gauge", name_hint(head_.column, known));
    return std::nullopt;
  }

  std::optional<TableColumn> decay_of(GaugeReader const& reader) {
    if (has("column"))
      wrong("column", "does not belong to a decay, which all points have", "leave it out");
    if (!reader.decay) {
      wrong("measure", "is known of lines with an origin only", "give the gauge line.origin");
      return std::nullopt;
    }
    return TableColumn{reader.name, ""};
  }

  std::optional<TableColumn> column_of_sums() {
    auto const columns = sums_columns();
    std::vector<std::string_view> names;
    for (TableColumn const& column : columns) {
      if (column.name == head_.sums) return column;
      names.push_back(column.name);
    }
    if (has("column")) wrong("column", "belongs to a gauge", "leave it out");
    wrong("sums", "is no column of sums.csv", name_hint(head_.sums, names));
    return std::nullopt;
  }

  void check_measure(TableColumn const& column) {
    bool const of_arrival = head_.measure == Measure::arrival || head_.measure == Measure::duration;
    if (head_.measure == Measure::decay_exponent && output_.from != OutputSource::gauge)
      wrong("measure", "is known of lines with an origin only");
    if (!of_arrival && head_.measure != Measure::impulse) return;
    if (output_.from != OutputSource::gauge || column.unit != "Pa")
      wrong("measure", "is known of pressures of gauges only");
    else if (of_arrival && !context_.has_arrivals)
      wrong("measure", "needs a pressure that counts as arrival",
            "give the case output.arrival_pressure, or add it as a parameter with one value");
  }

  toml::table const& table_;
  std::string const& prefix_;
  OutputContext const& context_;
  Source& source_;
  OutputHead head_;
  SweepOutput output_;
  bool good_ = true;
};

}  // namespace

std::optional<SweepOutput> read_output(toml::table const& table, std::string const& prefix,
                                       OutputContext const& context, Source& source) {
  return OutputReader(table, prefix, context, source).read();
}

}  // namespace moraine
