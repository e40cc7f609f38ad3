#include "app/blast_reader.hpp"

#include <fmt/core.h>

#include <numbers>

namespace moraine {
namespace {

/// Why a number is not accepted; empty where it is.
std::string_view refusal(Accepts accepts, double value) {
  switch (accepts) {
    case Accepts::positive:
      return value > 0.0 ? "" : "must be above zero";
    case Accepts::not_negative:
      return value >= 0.0 ? "" : "must not be negative";
    case Accepts::share:
      return value > 0.0 && value <= 1.0 ? "" : "must be above 0 and at most 1";
    case Accepts::below_right_angle:
      break;
  }
  bool const good = value >= 0.0 && value < std::numbers::pi / 2.0;
  return good ? "" : "must be at least 0 and below 90 deg";
}

}  // namespace

std::string const& BlastReader::text(std::string_view flag) const {
  static std::string const nothing;
  auto const found = options_.values.find(std::string(flag));
  return found == options_.values.end() ? nothing : found->second;
}

void BlastReader::complain(std::string_view flag, std::string_view value, std::string rule,
                           std::string hint) {
  mistakes_.mistake(std::string(flag), value.empty() ? std::string() : fmt::format("\"{}\"", value),
                    std::move(rule), std::move(hint));
}

std::optional<double> BlastReader::quantity(QuantityOption const& option, std::string const& text) {
  Conversion const read = to_si(text, option.dimension);
  if (!read.value) {
    bool const bare = read.rule.starts_with("is a plain number");
    complain(option.flag, text, read.rule,
             bare ? fmt::format("write \"{} {}\"", text, option.dimension.unit) : read.hint);
    return std::nullopt;
  }
  if (auto const rule = refusal(option.accepts, *read.value); !rule.empty()) {
    complain(option.flag, text, std::string(rule));
    return std::nullopt;
  }
  return read.value;
}

std::optional<double> BlastReader::factor(std::string_view flag) {
  Conversion const read = to_si(text(flag), Quantity::number);
  if (read.value && *read.value > 0.0) return read.value;
  complain(flag, text(flag), read.value ? "must be above zero" : read.rule, read.hint);
  return std::nullopt;
}

void BlastReader::refuse(std::vector<std::string> const& extras,
                         std::vector<std::string_view> const& known) {
  for (std::string const& extra : extras) {
    auto const name = nearest_name(extra, known);
    complain("", extra, "is not an option",
             name.empty() ? "see --help" : fmt::format("did you mean \"{}\"?", name));
  }
}

}  // namespace moraine
