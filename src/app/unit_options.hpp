// Values of options with units, and all mistakes in them together.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "base/units.hpp"

namespace moraine {

/// Reads the options of a command and collects what is wrong with them.
class UnitOptions {
 public:
  explicit UnitOptions(std::string command) : command_(std::move(command)) {}

  /// The value in SI units: a plain number is in SI already. Nothing for an empty text; nothing and
  /// a mistake for one that cannot be read or is not positive.
  std::optional<double> positive(std::string const& option, std::string const& text,
                                 Quantity quantity);

  /// The same, where zero is fine too.
  std::optional<double> not_negative(std::string const& option, std::string const& text,
                                     Quantity quantity);

  void mistake(std::string const& option, std::string const& value, std::string rule,
               std::string hint = {});

  /// Mistakes of a file, or of an exception from elsewhere.
  void add(InputErrors const& errors);
  void add(std::string const& file, std::string const& rule, std::string const& hint = {});

  /// Says of an output that exists that it is not overwritten, unless it may be, and of one that
  /// another option names too that it is.
  void check_output(std::string const& option, std::string const& file, bool force);

  /// Throws InputErrors if there are mistakes.
  void raise() const;

 private:
  std::optional<double> read(std::string const& option, std::string const& text, Quantity quantity);

  std::string command_;
  std::vector<InputProblem> problems_;
  std::map<std::filesystem::path, std::string> outputs_;  // and their options
};

/// Writes a file, complete or not at all; throws OutputError.
void write_text(std::string const& file, std::string const& text);

}  // namespace moraine
