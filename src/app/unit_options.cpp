#include "app/unit_options.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <system_error>

#include "output/atomic_file.hpp"

namespace moraine {

std::optional<double> UnitOptions::read(std::string const& option, std::string const& text,
                                        Quantity quantity) {
  if (text.empty()) return std::nullopt;
  Conversion const plain = to_si(text, Quantity::number);
  if (plain.value) return plain.value;
  Conversion conversion = to_si(text, quantity);
  if (!conversion.value)
    mistake(option, fmt::format("\"{}\"", text), std::move(conversion.rule),
            std::move(conversion.hint));
  return conversion.value;
}

std::optional<double> UnitOptions::positive(std::string const& option, std::string const& text,
                                            Quantity quantity) {
  auto const value = read(option, text, quantity);
  if (!value || *value > 0.0) return value;
  mistake(option, fmt::format("\"{}\"", text), "is not positive");
  return std::nullopt;
}

std::optional<double> UnitOptions::not_negative(std::string const& option, std::string const& text,
                                                Quantity quantity) {
  auto const value = read(option, text, quantity);
  if (!value || *value >= 0.0) return value;
  mistake(option, fmt::format("\"{}\"", text), "is negative");
  return std::nullopt;
}

void UnitOptions::mistake(std::string const& option, std::string const& value, std::string rule,
                          std::string hint) {
  problems_.push_back({command_, 0, 0, option, value, std::move(rule), std::move(hint)});
}

void UnitOptions::add(InputErrors const& errors) {
  problems_.insert(problems_.end(), errors.problems().begin(), errors.problems().end());
}

void UnitOptions::add(std::string const& file, std::string const& rule, std::string const& hint) {
  problems_.push_back({file, 0, 0, "", "", rule, hint});
}

void UnitOptions::check_output(std::string const& option, std::string const& file, bool force) {
  if (file.empty()) return;
  std::error_code ignored;
  auto const place = std::filesystem::absolute(file, ignored).lexically_normal();
  if (auto const [other, first] = outputs_.try_emplace(place, option); !first)
    mistake(option, fmt::format("\"{}\"", file), "is what " + other->second + " writes too",
            "name another file");
  if (force || !std::filesystem::exists(file, ignored)) return;
  mistake(option, fmt::format("\"{}\"", file), "exists and is not overwritten",
          "name another file or add --force");
}

void UnitOptions::raise() const {
  if (!problems_.empty()) throw InputErrors(problems_);
}

void write_text(std::string const& file, std::string const& text) {
  AtomicFile out(file);
  out.stream() << text;
  out.commit();
}

}  // namespace moraine
