// How the state of a run is saved and restored: one description for both directions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// Named pieces of state on their way out to, or back in from, a checkpoint.
///
/// A class with state has one function `exchange(Archive&)` that names each piece once. When
/// saving, the archive copies the values; when restoring, it overwrites them, arrays including
/// their length. So saving and restoring cannot disagree. Names are paths such as
/// "particles/density" and must be unique. Restoring throws std::runtime_error when a piece is
/// missing or of another type.
class Archive {
 public:
  virtual ~Archive() = default;

  /// True when values are read back and not saved.
  virtual bool restoring() const = 0;

  virtual void number(std::string_view name, double& value) = 0;
  virtual void number(std::string_view name, std::uint64_t& value) = 0;
  virtual void text(std::string_view name, std::string& value) = 0;

  /// Arrays; `unit` is for those who look into the file.
  virtual void array(std::string_view name, std::string_view unit, std::vector<double>& values) = 0;
  virtual void array(std::string_view name, std::string_view unit,
                     std::vector<std::uint64_t>& values) = 0;
  virtual void array(std::string_view name, std::string_view unit,
                     std::vector<std::uint32_t>& values) = 0;
  virtual void array(std::string_view name, std::string_view unit,
                     std::vector<std::int32_t>& values) = 0;
  virtual void array(std::string_view name, std::string_view unit,
                     std::vector<std::uint8_t>& values) = 0;
};

}  // namespace moraine
