#include "app/motion_synthesis.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/commands.hpp"
#include "base/gravity.hpp"
#include "output/text_columns.hpp"
#include "records/motion_fit.hpp"

namespace moraine {
namespace {

constexpr char const* command_name = "moraine motion synthesise";

MotionTarget target_of(MotionOptions const& options) {
  SynthesisOptions const& s = options.synthesis;
  UnitOptions input(command_name);
  MotionTarget target;
  auto const take = [&](double& value, char const* option, std::string const& text,
                        Quantity quantity) {
    if (text.empty()) input.mistake(option, "\"\"", "has no value");
    if (auto const read = input.positive(option, text, quantity)) value = *read;
  };
  take(target.peak_acceleration, "--pga", s.pga, Quantity::acceleration);
  take(target.velocity_ratio, "--pgv-pga", s.velocity_ratio, Quantity::time);
  take(target.predominant_period, "--predominant-period", s.predominant_period, Quantity::time);
  take(target.duration, "--duration", s.duration, Quantity::time);
  take(target.time_step, "--time-step", s.time_step, Quantity::time);
  target.envelope = {s.rise, s.stay};
  input.check_output("--write", options.out.record, options.out.force);
  input.check_output("--write-displacement", options.out.displacement, options.out.force);
  if (options.out.axis != "x" && options.out.axis != "y" && options.out.axis != "z")
    input.mistake("--axis", fmt::format("\"{}\"", options.out.axis), "is no axis",
                  "choose x, y or z");
  input.raise();
  return target;
}

std::string fit_as_text(MotionTarget const& target, FittedMotion const& fit) {
  TextColumns table({"measure", "unit"});
  for (auto const* heading : {"wanted", "got", "error"}) table.add_column(heading);
  auto const add = [&](char const* name, char const* unit, double wanted, double got) {
    table.add_row({name, unit, fmt::format("{:.4g}", wanted), fmt::format("{:.4g}", got),
                   fmt::format("{:.2f} %", 100.0 * std::fabs(got / wanted - 1.0))});
  };
  add("peak acceleration PGA", "g", target.peak_acceleration / standard_gravity,
      fit.peak_acceleration / standard_gravity);
  add("PGV/PGA", "s", target.velocity_ratio, fit.velocity_ratio);
  add("predominant period (PSA, 5 %)", "s", target.predominant_period, fit.predominant_period);
  NoiseFilter const& filter = fit.filter;
  return table.text() + fmt::format(
                            "\nlayer {:.4g} Hz, damping {:.4g}; corner {:.4g} Hz, damping {:.4g}; "
                            "sequence {} of the seed\n",
                            filter.ground_frequency, filter.ground_damping, filter.corner_frequency,
                            filter.corner_damping, fit.realisation);
}

nlohmann::json fit_as_json(MotionTarget const& target, FittedMotion const& fit,
                           std::uint64_t seed) {
  auto const measures = [](double pga, double ratio, double period) {
    return nlohmann::json{{"peak_acceleration_m_s2", pga},
                          {"velocity_ratio_s", ratio},
                          {"predominant_period_s", period}};
  };
  NoiseFilter const& filter = fit.filter;
  return {{"seed", seed},
          {"sequence", fit.realisation},
          {"wanted",
           measures(target.peak_acceleration, target.velocity_ratio, target.predominant_period)},
          {"got", measures(fit.peak_acceleration, fit.velocity_ratio, fit.predominant_period)},
          {"largest_relative_error", fit.error(target)},
          {"layer_frequency_hz", filter.ground_frequency},
          {"layer_damping", filter.ground_damping},
          {"corner_frequency_hz", filter.corner_frequency},
          {"corner_damping", filter.corner_damping}};
}

FittedMotion fit_or_refuse(MotionTarget const& target, std::uint64_t seed) {
  try {
    return fit_motion(target, seed);
  } catch (std::invalid_argument const& error) {
    throw InputErrors({{command_name, 0, 0, "", "", error.what(), ""}});
  }
}

}  // namespace

int synthesise_motion(MotionOptions const& options) {
  MotionTarget const target = target_of(options);
  FittedMotion fit = fit_or_refuse(target, options.synthesis.seed);
  fit.record.name = fmt::format("synthetic, seed {}", options.synthesis.seed);
  if (options.out.json)
    fmt::print("{}\n", fit_as_json(target, fit, options.synthesis.seed).dump(2));
  else
    fmt::print("{}", fit_as_text(target, fit));
  write_motion(fit.record, options.out);
  if (fit.error(target) <= close_enough) return ExitCode::done;
  fmt::print(stderr,
             "{}: no motion within {:g} % was found; the nearest is off by {:.1f} %. PGV/PGA is "
             "usually 0.16 to 0.5 times the predominant period\n",
             command_name, 100.0 * close_enough, 100.0 * fit.error(target));
  return ExitCode::failed;
}

}  // namespace moraine
