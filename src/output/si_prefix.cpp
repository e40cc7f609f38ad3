#include "output/si_prefix.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace moraine {
namespace {

struct Prefix {
  int exponent;
  std::string_view symbol;
};

constexpr std::array prefixes{Prefix{-9, "n"}, Prefix{-6, "µ"}, Prefix{-3, "m"}, Prefix{0, ""},
                              Prefix{3, "k"},  Prefix{6, "M"},  Prefix{9, "G"},  Prefix{12, "T"}};

/// Exponent of the prefix that brings `largest` into [1, 1000), within the limits. A little is
/// forgiven so that 999.9999 counts as 1000.
int prefix_exponent(double largest, int lowest, int highest) {
  if (!(largest > 0.0) || !std::isfinite(largest)) return 0;
  int const exponent = static_cast<int>(std::floor(std::log10(largest * (1.0 + 1e-9)) / 3.0)) * 3;
  return std::clamp(exponent, lowest, highest);
}

std::string_view symbol_of(int exponent) {
  return std::find_if(prefixes.begin(), prefixes.end(),
                      [&](Prefix const& p) { return p.exponent == exponent; })
      ->symbol;
}

std::string typeset(std::string_view unit) {
  std::string text;
  std::size_t const micro = unit == "us" ? 1 : 0;
  if (micro == 1) text = "µ";
  for (std::size_t i = micro; i < unit.size(); ++i) {
    bool const power = unit[i] == '^' && i + 1 < unit.size();
    if (power && unit[i + 1] == '2') {
      text += "²";
      ++i;
    } else if (power && unit[i + 1] == '3') {
      text += "³";
      ++i;
    } else if (unit[i] == ' ') {
      text += "·";
    } else {
      text += unit[i];
    }
  }
  return text;
}

/// The first unit symbol, which would carry the prefix: "J" of "J/kg".
std::string_view leading_symbol(std::string_view unit) {
  return unit.substr(0, unit.find_first_of(" /*^"));
}

bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 7> symbols{"Pa", "J", "W", "N", "s", "m", "Hz"};
  std::string_view const symbol = leading_symbol(unit);
  bool const powered = symbol.size() < unit.size() && unit[symbol.size()] == '^';
  return !powered && std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

DisplayUnit length_unit(double largest) {
  if (largest >= 2000.0) return {1e3, "km"};
  if (largest >= 0.5 || !(largest > 0.0)) return {1.0, "m"};
  if (largest >= 0.02) return {1e-2, "cm"};
  if (largest >= 1e-4) return {1e-3, "mm"};
  return {1e-6, "µm"};
}

std::string superscript(int exponent) {
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (char const c : fmt::format("{}", exponent))
    text += c == '-' ? std::string_view("⁻") : digits[static_cast<std::size_t>(c - '0')];
  return text;
}

}  // namespace

std::string power_of_ten(int exponent) { return "10" + superscript(exponent); }

std::string typeset_unit(std::string_view unit) { return typeset(unit); }

DisplayUnit display_unit(std::string_view unit, double largest) {
  if (unit == "m") return length_unit(largest);
  bool const motion = leading_symbol(unit) == "m";
  if (motion && largest >= 1e-2 && largest < 1e4) return {1.0, typeset(unit)};
  if (takes_prefix(unit)) {
    int const highest = unit == "s" ? 0 : 12;
    int const exponent = prefix_exponent(largest, -9, highest);
    return {std::pow(10.0, exponent), std::string(symbol_of(exponent)) + typeset(unit)};
  }
  bool const readable = !(largest > 0.0) || (largest >= 1e-2 && largest < 1e5);
  int const exponent = readable ? 0 : prefix_exponent(largest, -300, 300);
  if (exponent == 0) return {1.0, typeset(unit)};
  std::string text = power_of_ten(exponent);
  if (!unit.empty()) text += " " + typeset(unit);
  return {std::pow(10.0, exponent), text};
}

std::string with_unit(double value, std::string_view unit, int digits) {
  DisplayUnit const shown = display_unit(unit, std::abs(value));
  double const number = value / shown.factor;
  double const size = std::abs(number);
  int const before = size >= 1.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  std::string text = fmt::format("{:.{}f}", number, std::max(0, digits - before));
  if (!shown.unit.empty()) text += " " + shown.unit;
  return text;
}

std::string with_prefix(double value) {
  int const exponent = prefix_exponent(std::abs(value), 0, 12);
  double const number = value / std::pow(10.0, exponent);
  // Limits as they are after rounding: 9.999 is written 10.0.
  int const decimals = std::abs(number) >= 99.95 ? 0 : std::abs(number) >= 9.995 ? 1 : 2;
  std::string text = fmt::format("{:.{}f}", number, decimals);
  if (exponent != 0) text += fmt::format(" {}", symbol_of(exponent));
  return text;
}

}  // namespace moraine
