#include "output/blast/output_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace moraine::blast {

std::string OutputUnits::unit(Measure measure) const {
  std::string const& own = chosen[static_cast<std::size_t>(info(measure).kind)];
  return own.empty() ? std::string(unit_of(measure, system)) : own;
}

double OutputUnits::shown(Measure measure, double value) const {
  return value / unit_factor(info(measure).kind, unit(measure));
}

std::string readable(double value) {
  if (!std::isfinite(value)) return "none";
  double const size = std::abs(value);
  if (size != 0.0 && (size < 1e-3 || size >= 1e6)) return fmt::format("{:.3e}", value);
  int const before = size >= 1.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  int const leading =
      size > 0.0 && size < 1.0 ? static_cast<int>(-std::floor(std::log10(size))) : 1;
  int const decimals = size >= 1.0 ? std::max(0, 4 - before) : 3 + leading;
  double const rounding = before > 4 ? std::pow(10.0, before - 4) : 1.0;
  if (before > 4) return fmt::format("{:.0f}", std::round(value / rounding) * rounding);
  return fmt::format("{:.{}f}", value, size == 0.0 ? 0 : decimals);
}

std::string words(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string with_unit(std::string_view name, std::string_view unit) {
  return unit == "1" ? words(name) : fmt::format("{} ({})", words(name), unit);
}

}  // namespace moraine::blast
