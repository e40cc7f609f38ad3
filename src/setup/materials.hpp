// The materials of the folder materials/, as part of the program.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/embedded_text.hpp"
#include "setup/case.hpp"

namespace moraine {

/// The files materials/*.toml; the build writes this list (cmake/MoraineTexts.cmake).
std::span<EmbeddedText const> material_texts();

/// A constant of a material, with where it comes from.
struct MaterialValue {
  std::string key;   // of the equation of state: "reference_density"
  std::string text;  // as written in the file: "1630 kg/m^3"
  std::string source;
};

/// A number that the equation of state must give with these constants: a test compares.
struct MaterialReference {
  std::string key;     // "pressure", "sound_speed": at the reference state; "detonation_velocity",
                       // "detonation_pressure": of the Chapman-Jouguet state
  double value = 0.0;  // SI
  double tolerance = 0.0;  // relative
  std::string text;
  std::string source;
};

struct ShippedMaterial {
  std::string meaning;
  MaterialSpec spec;  // with the name of the file
  std::vector<MaterialValue> values;
  std::vector<MaterialReference> references;
};

/// Reads a material file: `meaning`, `eos`, one table { value, source } for every constant of that
/// equation of state, and tables { value, source, tolerance } below `reference`; a solid has a
/// table `strength` of the same kind, and may have `tension`. Throws InputErrors for anything
/// missing, unknown or invalid, and std::runtime_error for a text that is no TOML.
ShippedMaterial parse_material(std::string_view text, std::string_view name);

/// All of them, sorted by name; read once.
std::span<ShippedMaterial const> shipped_materials();

/// Throws InputErrors with the nearest name for a name that there is not.
ShippedMaterial const& shipped_material(std::string_view name);

/// What `moraine materials` prints: all names, or one material with values and sources.
std::string list_materials();
std::string describe(ShippedMaterial const& material);

}  // namespace moraine
