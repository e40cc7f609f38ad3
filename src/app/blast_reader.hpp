// Reads single options of `moraine blast` and collects what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/blast_command.hpp"
#include "app/blast_topics.hpp"
#include "app/unit_options.hpp"
#include "base/input_error.hpp"

namespace moraine {

class BlastReader {
 public:
  BlastReader(std::string command, BlastOptions const& options)
      : mistakes_(std::move(command)), options_(options) {}

  /// What was written behind an option; empty where nothing was.
  std::string const& text(std::string_view flag) const;
  bool given(std::string_view flag) const { return !text(flag).empty(); }

  void complain(std::string_view flag, std::string_view value, std::string rule,
                std::string hint = {});

  /// The value of an option that was given, in SI, or nothing and a complaint.
  std::optional<double> quantity(QuantityOption const& option, std::string const& text);
  /// The same for a plain number above zero.
  std::optional<double> factor(std::string_view flag);

  /// Complains about everything that is no option, with the nearest one.
  void refuse(std::vector<std::string> const& extras, std::vector<std::string_view> const& known);

  /// The entry of a list with this name, or null and a complaint.
  template <class Entry, std::size_t extent>
  Entry const* entry(std::string_view flag, std::span<Entry const, extent> list) {
    std::string const& name = text(flag);
    std::vector<std::string_view> known;
    for (Entry const& candidate : list) {
      if (candidate.name == name) return &candidate;
      known.push_back(candidate.name);
    }
    complain(flag, name, "is not in the list", name_hint(name, known));
    return nullptr;
  }

  /// Complaints of an exception from elsewhere.
  void complain(InputErrors const& errors) { mistakes_.add(errors); }

  /// Complains about a file that exists, unless it may be replaced.
  void keep_existing(std::string_view flag) {
    mistakes_.check_output(std::string(flag), text(flag), options_.force);
  }

  /// Throws InputErrors if there were complaints.
  void finish() const { mistakes_.raise(); }

 private:
  UnitOptions mistakes_;
  BlastOptions const& options_;
};

}  // namespace moraine
