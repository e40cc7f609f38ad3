#include "output/motion/measure_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/gravity.hpp"
#include "output/text_columns.hpp"
#include "records/fourier_spectrum.hpp"

namespace moraine {
namespace {

/// A line of the table.
struct Row {
  std::string_view label;
  std::string_view unit;  // of the table
  double factor;          // SI per unit of the table
  std::string_view key;   // in JSON, with its SI unit
  double (*value)(MeasuredMotion const&);
};

constexpr double g = standard_gravity;

constexpr Row rows[] = {
    {"time step", "s", 1, "time_step_s", [](auto const& m) { return m.record.time_step; }},
    {"duration", "s", 1, "duration_s", [](auto const& m) { return m.measures.duration; }},
    {"peak acceleration PGA", "g", g, "peak_acceleration_m_s2",
     [](auto const& m) { return m.measures.acceleration.value; }},
    {"  at", "s", 1, "peak_acceleration_time_s",
     [](auto const& m) { return m.measures.acceleration.time; }},
    {"peak velocity PGV", "m/s", 1, "peak_velocity_m_s",
     [](auto const& m) { return m.measures.velocity.value; }},
    {"  at", "s", 1, "peak_velocity_time_s",
     [](auto const& m) { return m.measures.velocity.time; }},
    {"peak displacement PGD", "m", 1, "peak_displacement_m",
     [](auto const& m) { return m.measures.displacement.value; }},
    {"  at", "s", 1, "peak_displacement_time_s",
     [](auto const& m) { return m.measures.displacement.time; }},
    {"PGV/PGA", "s", 1, "velocity_ratio_s",
     [](auto const& m) { return m.measures.velocity.value / m.measures.acceleration.value; }},
    {"rms acceleration", "g", g, "rms_acceleration_m_s2",
     [](auto const& m) { return m.measures.rms_acceleration; }},
    {"Arias intensity", "m/s", 1, "arias_intensity_m_s",
     [](auto const& m) { return m.measures.arias_intensity; }},
    {"characteristic intensity", "-", 1, "characteristic_intensity",
     [](auto const& m) { return m.measures.characteristic_intensity; }},
    {"cumulative absolute velocity CAV", "m/s", 1, "cumulative_absolute_velocity_m_s",
     [](auto const& m) { return m.measures.cumulative_velocity; }},
    {"CAV/PGA", "s", 1, "cumulative_velocity_ratio_s",
     [](auto const& m) { return m.measures.cumulative_velocity / m.measures.acceleration.value; }},
    {"specific energy density", "m²/s", 1, "specific_energy_density_m2_s",
     [](auto const& m) { return m.measures.specific_energy_density; }},
    {"velocity spectrum intensity VSI", "m", 1, "velocity_spectrum_intensity_m",
     [](auto const& m) { return m.measures.velocity_intensity; }},
    {"Housner intensity", "m", 1, "housner_intensity_m",
     [](auto const& m) { return m.measures.housner_intensity; }},
    {"acceleration spectrum intensity ASI", "g s", g, "acceleration_spectrum_intensity_m_s",
     [](auto const& m) { return m.measures.acceleration_intensity; }},
    {"effective design acceleration EDA", "g", g, "effective_design_acceleration_m_s2",
     [](auto const& m) { return m.measures.design_acceleration; }},
    {"sustained acceleration (third)", "g", g, "sustained_acceleration_m_s2",
     [](auto const& m) { return m.measures.sustained_acceleration; }},
    {"sustained velocity (third)", "m/s", 1, "sustained_velocity_m_s",
     [](auto const& m) { return m.measures.sustained_velocity; }},
    {"A95", "g", g, "a95_m_s2", [](auto const& m) { return m.measures.a95; }},
    {"significant duration D5-95", "s", 1, "significant_duration_s",
     [](auto const& m) { return m.measures.significant.length(); }},
    {"  from", "s", 1, "significant_from_s",
     [](auto const& m) { return m.measures.significant.from; }},
    {"bracketed duration (0.05 g)", "s", 1, "bracketed_duration_s",
     [](auto const& m) { return m.measures.bracketed.length(); }},
    {"  from", "s", 1, "bracketed_from_s", [](auto const& m) { return m.measures.bracketed.from; }},
    {"predominant period (PSA, 5 %)", "s", 1, "predominant_period_s",
     [](auto const& m) { return m.measures.predominant_period; }},
    {"dominant frequency (power)", "Hz", 1, "dominant_frequency_hz",
     [](auto const& m) { return m.dominant_frequency; }},
};

}  // namespace

MeasuredMotion measured_motion(GroundRecord record) {
  MeasuredMotion motion{std::move(record), {}, 0.0};
  motion.measures = measure(motion.record);
  motion.dominant_frequency = dominant_frequency(motion.record);
  return motion;
}

std::string measures_as_text(std::vector<MeasuredMotion> const& motions) {
  TextColumns table({"measure", "unit"});
  for (MeasuredMotion const& motion : motions) table.add_column(motion.record.name);
  for (Row const& row : rows) {
    std::vector<std::string> cells{std::string(row.label), std::string(row.unit)};
    for (MeasuredMotion const& motion : motions)
      cells.push_back(fmt::format("{:.4g}", row.value(motion) / row.factor));
    table.add_row(std::move(cells));
  }
  return table.text();
}

std::string measures_as_csv(std::vector<MeasuredMotion> const& motions) {
  std::string text = "measure,unit";
  for (MeasuredMotion const& motion : motions) text += "," + quoted_cell(motion.record.name);
  text += '\n';
  std::string_view whole;  // what "at" and "from" belong to
  for (Row const& row : rows) {
    bool const part = row.label.starts_with("  ");
    if (!part) whole = row.label;
    text += quoted_cell(part ? fmt::format("{},{}", whole, row.label.substr(1))
                             : std::string(row.label));
    text += fmt::format(",{}", row.unit);
    for (MeasuredMotion const& motion : motions)
      text += fmt::format(",{}", row.value(motion) / row.factor);
    text += '\n';
  }
  return text;
}

nlohmann::json measures_as_json(std::vector<MeasuredMotion> const& motions) {
  nlohmann::json list = nlohmann::json::array();
  for (MeasuredMotion const& motion : motions) {
    nlohmann::json entry{{"name", motion.record.name}, {"values", motion.record.size()}};
    for (Row const& row : rows) entry[std::string(row.key)] = row.value(motion);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace moraine
