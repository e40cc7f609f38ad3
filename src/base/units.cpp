#include "base/units.hpp"

#include <fmt/core.h>
#include <udunits2.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <span>

#include "base/input_error.hpp"

namespace moraine {
namespace {

constexpr std::array<QuantityInfo, quantity_count> quantities{{
    {Quantity::number, "a plain number", "1", {"1"}},
    {Quantity::length, "a length", "m", {"m", "cm", "mm", "km"}},
    {Quantity::time, "a time", "s", {"s", "ms", "us", "min"}},
    {Quantity::velocity, "a velocity", "m/s", {"m/s", "km/s", "cm/s"}},
    {Quantity::acceleration, "an acceleration", "m/s^2", {"m/s^2", "g0", "cm/s^2"}},
    {Quantity::density, "a density", "kg/m^3", {"kg/m^3", "g/cm^3"}},
    {Quantity::pressure, "a pressure", "Pa", {"Pa", "kPa", "MPa", "GPa", "bar", "atm"}},
    {Quantity::specific_energy, "a specific energy", "J/kg", {"J/kg", "kJ/kg", "MJ/kg", "J/g"}},
    {Quantity::mass, "a mass", "kg", {"kg", "g", "t"}},
    {Quantity::angle, "an angle", "rad", {"rad", "deg"}},
    {Quantity::angular_velocity, "an angular velocity", "rad/s", {"rad/s", "deg/s", "rpm"}},
    {Quantity::frequency, "a frequency", "Hz", {"Hz", "kHz"}},
    {Quantity::dynamic_viscosity, "a dynamic viscosity", "Pa s", {"Pa s", "mPa s"}},
}};

static_assert(
    [] {
      for (std::size_t i = 0; i < quantity_count; ++i)
        if (static_cast<std::size_t>(quantities[i].quantity) != i) return false;
      return true;
    }(),
    "quantities must be listed in the order of the enum");

struct FreeSystem {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, FreeSystem>;
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

System load_system() {
  ut_set_error_message_handler(ut_ignore);
  return System(ut_read_xml(nullptr));
}

ut_system* unit_system() {
  static System const system = load_system();
  return system.get();
}

bool is_word_byte(char c) {
  auto const byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
         (byte >= 'A' && byte <= 'Z') || byte == '_';
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  auto const first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// UDUNITS-2 reads "g0" as gram to the power of zero and does not know "deg".
std::string without_aliases(std::string_view unit) {
  std::string result;
  for (std::size_t begin = 0; begin < unit.size();) {
    std::size_t end = begin;
    while (end < unit.size() && is_word_byte(unit[end])) ++end;
    auto const word = unit.substr(begin, end - begin);
    if (word == "g0")
      result += "standard_free_fall";
    else if (word == "deg")
      result += "degree";
    else
      result += word;
    if (end < unit.size()) result += unit[end];
    begin = end + 1;
  }
  return result;
}

// A number that is not the exponent of a unit: UDUNITS-2 would multiply by it, so that "10 m 3"
// would silently be 30 m.
bool has_loose_number(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i])) continue;
    char const before = i > 0 ? unit[i - 1] : ' ';
    char const earlier = i > 1 ? unit[i - 2] : ' ';
    bool const reciprocal = i == 0 && unit.size() > 1 && unit[1] == '/';
    bool const signed_exponent =
        (before == '-' || before == '+') && (is_word_byte(earlier) || earlier == '^');
    if (!is_word_byte(before) && before != '^' && !signed_exponent && !reciprocal) return true;
  }
  return false;
}

Unit parse_unit(std::string_view text) {
  std::string const plain = without_aliases(text);
  return Unit(ut_parse(unit_system(), plain.c_str(), UT_UTF8));
}

// ut_are_convertible alone will not do: it accepts reciprocals and takes radians for numbers.
bool has_dimension(ut_unit const* unit, std::string_view si_unit) {
  Unit const si = parse_unit(si_unit);
  Unit const ratio(si ? ut_divide(unit, si.get()) : nullptr);
  if (!ratio || !ut_is_dimensionless(ratio.get())) return false;
  std::array<char, 128> text{};
  int const length = ut_format(ratio.get(), text.data(), text.size(), UT_ASCII | UT_DEFINITION);
  if (length < 0 || static_cast<std::size_t>(length) >= text.size()) return false;
  return std::string_view(text.data()).find("rad") == std::string_view::npos;
}

std::string what_it_is(ut_unit const* unit) {
  for (auto const& entry : quantities)
    if (has_dimension(unit, entry.unit)) return fmt::format("is {}", entry.name);
  return "has another dimension";
}

std::string expectation(Dimension const& wanted) {
  if (wanted.unit == info(Quantity::number).unit) return "a plain number is expected";
  return fmt::format("{} is expected ({})", wanted.name, wanted.unit);
}

std::optional<double> converted(double value, ut_unit const* unit, Dimension const& expected) {
  Unit const si = parse_unit(expected.unit);
  Converter const converter(ut_get_converter(const_cast<ut_unit*>(unit), si.get()));
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0) return std::nullopt;
  double const factor = cv_convert_double(converter.get(), 1.0);
  double const inverse = std::round(1.0 / factor);
  // 0.001 has no exact double but 1000 has: dividing rounds only once.
  bool const whole = factor < 1.0 && std::abs(factor * inverse - 1.0) < 1e-14;
  return whole ? value / inverse : value * factor;
}

std::string unit_hint(std::string_view unit, Dimension const& expected) {
  std::span<std::string_view const> usual = expected.usual;
  while (!usual.empty() && usual.back().empty()) usual = usual.first(usual.size() - 1);
  if (auto const name = nearest_name(unit, usual); !name.empty())
    return fmt::format("did you mean \"{}\"?", name);
  return {};
}

std::string dimension_hint(double value, std::string_view unit, Dimension const& expected) {
  if (expected.unit == info(Quantity::acceleration).unit && unit == "g")
    return fmt::format("g is gram; did you mean \"{} g0\" (standard gravity)?", value);
  if (unit.empty())
    return fmt::format("write {0} without quotes for SI, or \"{0} {1}\"", value, expected.unit);
  return {};
}

}  // namespace

QuantityInfo const& info(Quantity quantity) {
  return quantities[static_cast<std::size_t>(quantity)];
}

Conversion to_si(std::string_view text, Quantity expected) {
  QuantityInfo const& wanted = info(expected);
  return to_si(text, Dimension{wanted.name, wanted.unit, wanted.usual});
}

Conversion to_si(std::string_view text, Dimension const& expected) {
  static std::mutex mutex;
  std::lock_guard const lock(mutex);
  if (unit_system() == nullptr)
    return {{}, "cannot be read: the unit database of UDUNITS-2 is missing", {}};

  std::string_view rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0.0;
  auto const [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  std::string_view const unit_text =
      trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
  if (error != std::errc{} || !std::isfinite(value) || has_loose_number(unit_text))
    return {{}, fmt::format("is not a number and a unit; {}", expectation(expected)), {}};

  // "1/s" leaves "/s" behind its number.
  Unit const unit = parse_unit(unit_text.starts_with('/') ? fmt::format("1{}", unit_text)
                                                          : std::string(unit_text));
  if (!unit)
    return {{},
            fmt::format("has an unknown unit \"{}\"; {}", unit_text, expectation(expected)),
            unit_hint(unit_text, expected)};
  if (!has_dimension(unit.get(), expected.unit))
    return {{},
            fmt::format("{}; {}", what_it_is(unit.get()), expectation(expected)),
            dimension_hint(value, unit_text, expected)};
  auto const si = converted(value, unit.get(), expected);
  if (!si || !std::isfinite(*si))
    return {{}, fmt::format("cannot be converted; {}", expectation(expected)), {}};
  return {si, {}, {}};
}

}  // namespace moraine
