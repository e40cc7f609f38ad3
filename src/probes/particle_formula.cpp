#include "probes/particle_formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>
#include <stdexcept>

#include "probes/solid_state.hpp"

namespace moraine {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The place behind a number that begins at k, its exponent included.
std::size_t behind_number(std::string const& text, std::size_t k) {
  while (k < text.size() && (is_digit(text[k]) || text[k] == '.')) ++k;
  if (k >= text.size() || (text[k] != 'e' && text[k] != 'E')) return k;
  std::size_t const sign = k + 1 < text.size() && (text[k + 1] == '+' || text[k + 1] == '-');
  if (k + 1 + sign >= text.size() || !is_digit(text[k + 1 + sign])) return k;
  k += 1 + sign;
  while (k < text.size() && is_digit(text[k])) ++k;
  return k;
}

}  // namespace

std::vector<std::string> const& particle_variables() {
  static std::vector<std::string> const names{"x",
                                              "y",
                                              "z",
                                              "velocity_x",
                                              "velocity_y",
                                              "velocity_z",
                                              "speed",
                                              "density",
                                              "pressure",
                                              "specific_energy",
                                              "sound_speed",
                                              "mass",
                                              "volume",
                                              "smoothing_length",
                                              "burn_fraction",
                                              "distension",
                                              "stress_xx",
                                              "stress_yy",
                                              "stress_zz",
                                              "stress_xy",
                                              "stress_xz",
                                              "stress_yz",
                                              "shear_stress",
                                              "plastic_strain",
                                              "plastic_work",
                                              "time"};
  return names;
}

std::vector<std::string_view> const& known_names() {
  static std::vector<std::string_view> const names = [] {
    std::vector<std::string_view> all(particle_variables().begin(), particle_variables().end());
    all.insert(all.end(), Formula::built_in_names().begin(), Formula::built_in_names().end());
    return all;
  }();
  return names;
}

std::optional<UnknownName> unknown_name(std::string const& formula) {
  auto const& known = known_names();
  for (std::size_t k = 0; k < formula.size();) {
    if (is_digit(formula[k]) || formula[k] == '.') {
      k = behind_number(formula, k);
    } else if (is_letter(formula[k])) {
      std::size_t const first = k;
      while (k < formula.size() && (is_letter(formula[k]) || is_digit(formula[k]))) ++k;
      std::string const name = formula.substr(first, k - first);
      if (std::find(known.begin(), known.end(), name) == known.end())
        return UnknownName{name, first + 1};
    } else {
      ++k;
    }
  }
  return std::nullopt;
}

std::string formula_fault(std::string const& formula) {
  try {
    Formula const sound(formula, particle_variables());
    return {};
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
}

namespace {

/// Stress s - p 1 of a solid, its shear part, and what yielding has done; of a fluid -p 1.
void set_solid(ParticleStore const& store, std::size_t i, std::span<double, 9> values) {
  double const p = store.scalar(Field::pressure)[i];
  if (!store.has(Field::deviatoric_stress)) {
    for (std::size_t k = 0; k < 3; ++k) values[k] = -p;
    return;
  }
  Deviator const s = deviator_of(store, i);
  for (std::size_t k = 0; k < 6; ++k) values[k] = s[k] - (k < 3 ? p : 0.0);
  values[6] = shear_norm(s);
  values[7] = store.scalar(Field::plastic_strain)[i];
  values[8] = store.scalar(Field::plastic_work)[i];
}

}  // namespace

double ParticleFormula::operator()(ParticleStore const& store, std::size_t i,
                                   double smoothing_length, double time) const {
  std::array<double, 26> values{};
  double speed2 = 0.0;
  for (int axis = 0; axis < store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    double const v = store.component(Field::velocity, axis)[i];
    values[k] = store.component(Field::position, axis)[i];
    values[3 + k] = v;
    speed2 += v * v;
  }
  double const mass = store.scalar(Field::mass)[i];
  double const density = store.scalar(Field::density)[i];
  values[6] = std::sqrt(speed2);
  values[7] = density;
  values[8] = store.scalar(Field::pressure)[i];
  values[9] = store.scalar(Field::specific_energy)[i];
  values[10] = store.scalar(Field::sound_speed)[i];
  values[11] = mass;
  values[12] = mass / density;
  bool const varies = store.has(Field::smoothing_length);
  values[13] = varies ? store.scalar(Field::smoothing_length)[i] : smoothing_length;
  values[14] = store.has(Field::burn_fraction) ? store.scalar(Field::burn_fraction)[i] : 0.0;
  values[15] = store.has(Field::distension) ? store.scalar(Field::distension)[i] : 1.0;
  set_solid(store, i, std::span(values).subspan<16, 9>());
  values[25] = time;
  return formula_(values);
}

}  // namespace moraine
