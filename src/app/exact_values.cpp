// Parameters of `moraine exact`: from texts to SI values, with all mistakes at once.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>

#include "app/exact_solution.hpp"
#include "base/input_error.hpp"
#include "setup/materials.hpp"

namespace moraine {
namespace {

InputProblem problem(std::string key, std::string_view value, std::string rule, std::string hint) {
  return {"moraine exact", 0, 0, std::move(key), fmt::format("\"{}\"", value), std::move(rule),
          std::move(hint)};
}

/// A plain number is in SI units, whatever its dimension.
Conversion number_of(std::string_view text, ExactParameter const& parameter) {
  double value = 0.0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  Conversion result = error == std::errc() && end == text.data() + text.size()
                          ? Conversion{value, {}, {}}
                          : to_si(text, parameter.dimension);
  if (!result.value) return result;
  if (!std::isfinite(*result.value)) return {{}, "must be finite", {}};
  if (parameter.range == ExactRange::positive && !(*result.value > 0.0))
    return {{}, "must be positive", {}};
  if (parameter.range == ExactRange::not_negative && !(*result.value >= 0.0))
    return {{}, "must not be negative", {}};
  return result;
}

std::vector<std::string_view> valid_names(ExactParameter const& parameter) {
  std::vector<std::string_view> names = parameter.names;
  if (parameter.kind == ExactValueKind::choice) return names;
  for (ShippedMaterial const& material : shipped_materials())
    if (parameter.kind == ExactValueKind::material ||
        std::holds_alternative<Jwl>(material.spec.eos))
      names.push_back(material.spec.name);
  return names;
}

std::string_view rule_of(ExactValueKind kind) {
  if (kind == ExactValueKind::material) return "is no shipped material";
  return kind == ExactValueKind::explosive ? "is no shipped explosive"
                                           : "is not one of the choices";
}

class ValueReader {
 public:
  explicit ValueReader(ExactSolution const& solution) : solution_(solution) {}

  /// Reads one value; `key` is what messages call it.
  void read(ExactParameter const& parameter, std::string_view text, std::string const& key) {
    if (parameter.kind == ExactValueKind::number) {
      Conversion const number = number_of(text, parameter);
      if (number.value)
        values_.numbers[std::string(parameter.key)] = *number.value;
      else
        problems_.push_back(problem(key, text, number.rule, number.hint));
      return;
    }
    std::vector<std::string_view> const names = valid_names(parameter);
    if (std::find(names.begin(), names.end(), text) == names.end())
      problems_.push_back(
          problem(key, text, std::string(rule_of(parameter.kind)), name_hint(text, names)));
    values_.texts[std::string(parameter.key)] = text;
  }

  /// Reads "key=value".
  void read_pair(std::string const& text) {
    std::size_t const equals = text.find('=');
    if (equals == std::string::npos) {
      problems_.push_back(problem("--parameters", text, "is not of the form key=value", ""));
      return;
    }
    std::string const key = text.substr(0, equals);
    if (!given_.insert(key).second) {
      problems_.push_back(problem("--parameters", text, "gives a parameter twice", ""));
      return;
    }
    for (ExactParameter const& parameter : solution_.parameters)
      if (parameter.key == key)
        return read(parameter, std::string_view(text).substr(equals + 1), key);
    refuse_key(key);
  }

  void read_time(std::string const& text) {
    for (ExactParameter const& parameter : solution_.parameters)
      if (parameter.key == "time") {
        given_.insert("time");
        return read(parameter, text, "--time");
      }
    problems_.push_back(
        problem("--time", text, fmt::format("is no use: {} has no time", solution_.name), ""));
  }

  ExactValues finish(int points) {
    for (ExactParameter const& parameter : solution_.parameters)
      if (!given_.contains(std::string(parameter.key)) && !parameter.fallback.empty())
        read(parameter, parameter.fallback, std::string(parameter.key));
    if (!problems_.empty()) throw InputErrors(std::move(problems_));
    values_.points = points;
    return std::move(values_);
  }

 private:
  void refuse_key(std::string const& key) {
    std::vector<std::string_view> names;
    for (ExactParameter const& parameter : solution_.parameters) names.push_back(parameter.key);
    problems_.push_back(problem("--parameters", key,
                                fmt::format("is no parameter of {}", solution_.name),
                                name_hint(key, names)));
  }

  ExactSolution const& solution_;
  ExactValues values_;
  std::set<std::string> given_;
  std::vector<InputProblem> problems_;
};

}  // namespace

ExactParameter exact_number(std::string_view key, std::string_view fallback, Quantity quantity,
                            ExactRange range, std::string_view meaning) {
  QuantityInfo const& known = info(quantity);
  return {key,   fallback, meaning, ExactValueKind::number, {known.name, known.unit, known.usual},
          range, {}};
}

ExactParameter exact_material(std::string_view key, std::string_view fallback,
                              std::string_view meaning, std::vector<std::string_view> others) {
  return {key, fallback, meaning, ExactValueKind::material, {}, {}, std::move(others)};
}

ExactParameter exact_explosive(std::string_view meaning) {
  return {"explosive", "tnt", meaning, ExactValueKind::explosive, {}, {}, {}};
}

ExactParameter exact_choice(std::string_view key, std::vector<std::string_view> names,
                            std::string_view fallback, std::string_view meaning) {
  return {key, fallback, meaning, ExactValueKind::choice, {}, {}, std::move(names)};
}

ExactValues read_exact_values(ExactSolution const& solution, std::vector<std::string> const& texts,
                              std::string const& time, int points) {
  ValueReader reader(solution);
  if (!time.empty()) reader.read_time(time);
  for (std::string const& text : texts) reader.read_pair(text);
  return reader.finish(points);
}

MaterialPoint material_point(ExactValues const& values, std::string const& prefix, Eos const& eos) {
  bool const dense = values.has(prefix + "density"), pressed = values.has(prefix + "pressure");
  bool const warm = values.has(prefix + "energy");
  if (dense && pressed && warm)
    throw std::invalid_argument(fmt::format(
        "{0}density, {0}pressure and {0}energy are one too many: leave one out", prefix));
  double rho = dense ? values.number(prefix + "density") : reference_density(eos);
  double e = warm ? values.number(prefix + "energy") : reference_energy(eos);
  if (!pressed) return {rho, e};
  double const p = values.number(prefix + "pressure");
  std::visit(
      [&](auto const& law) {
        if (dense)
          e = law.energy_at_pressure(rho, p);
        else
          rho = law.density_at_pressure(p, e);
        // A law without energy in its pressure answers with what it has.
        if (!(std::fabs(law.pressure(rho, e) - p) <= 1e-6 * std::fabs(p) + 1.0))
          throw std::invalid_argument(
              fmt::format("{0}pressure: the equation of state does not have it{1}", prefix,
                          dense ? fmt::format(" at this {}density", prefix) : ""));
      },
      eos);
  return {rho, e};
}

std::vector<double> even_steps(double low, double high, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(low + (high - low) * k / (count - 1));
  return values;
}

}  // namespace moraine
