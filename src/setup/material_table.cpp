// The table of parameters: materials. An equation of state adds its keys here.
#include <string_view>
#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

constexpr std::string_view water = "water; Liu and Liu, Smoothed Particle Hydrodynamics (2003)";
constexpr std::string_view tnt =
    "TNT; Dobratz and Crawford, UCRL-52997 (1985); energy of Liu and Liu (2003)";
constexpr std::string_view air = "air at 15 degC and one atmosphere";

// The constants of one law, an alternative of Eos; their defaults are those of the struct.
template <class Law>
class LawTable {
 public:
  explicit LawTable(std::vector<Entry<MaterialSpec>>& table) : table_(table) {}

  template <auto Member>
  void add(std::string_view key, Quantity quantity, Limits limits, std::string_view meaning,
           std::string_view source = {}) {
    table_.push_back(
        member_of<MaterialSpec, &MaterialSpec::eos, Law, Member>({.section = Section::material,
                                                                  .key = key,
                                                                  .quantity = quantity,
                                                                  .preset = Law{}.*Member,
                                                                  .limits = limits,
                                                                  .when_key = "eos",
                                                                  .when_value = Law::name,
                                                                  .meaning = meaning,
                                                                  .source = source}));
  }

 private:
  std::vector<Entry<MaterialSpec>>& table_;
};

void add_tait(std::vector<Entry<MaterialSpec>>& entries) {
  LawTable<Tait> table(entries);
  table.add<&Tait::reference_density>("reference_density", Quantity::density, Limits::positive(),
                                      "density at the background pressure", "water");
  table.add<&Tait::reference_sound_speed>(
      "reference_sound_speed", Quantity::velocity, Limits::positive(),
      "sound speed at the reference density; ten times the largest velocity is usual", "water");
  table.add<&Tait::exponent>("exponent", Quantity::number, {.min = 1.0},
                             "exponent of the density ratio",
                             "water; Cole, Underwater Explosions (1948)");
  table.add<&Tait::background_pressure>("background_pressure", Quantity::pressure, Limits::none(),
                                        "pressure at the reference density");
  table.add<&Tait::reference_energy>("reference_energy", Quantity::specific_energy, Limits::none(),
                                     "initial energy; no effect on the pressure");
}

void add_water(std::vector<Entry<MaterialSpec>>& entries) {
  using Water = WaterPolynomial;
  LawTable<Water> table(entries);
  table.add<&Water::reference_density>("reference_density", Quantity::density, Limits::positive(),
                                       "density at zero compression", water);
  table.add<&Water::a1>("a1", Quantity::pressure, Limits::positive(),
                        "coefficient of the compression", "water; sound speed 1480 m/s");
  table.add<&Water::a2>("a2", Quantity::pressure, Limits::not_negative(),
                        "coefficient of its square", water);
  table.add<&Water::a3>("a3", Quantity::pressure, Limits::not_negative(), "coefficient of its cube",
                        water);
  table.add<&Water::b0>("b0", Quantity::number, Limits::not_negative(), "coefficient of the energy",
                        water);
  table.add<&Water::b1>("b1", Quantity::number, Limits::not_negative(),
                        "coefficient of energy times compression", water);
  table.add<&Water::reference_energy>("reference_energy", Quantity::specific_energy, Limits::none(),
                                      "initial energy; 205.4 J/kg gives one atmosphere", water);
  table.add<&Water::cavitation_pressure>("cavitation_pressure", Quantity::pressure, Limits::none(),
                                         "least pressure that the water bears");
}

void add_jwl(std::vector<Entry<MaterialSpec>>& entries) {
  LawTable<Jwl> table(entries);
  table.add<&Jwl::reference_density>("reference_density", Quantity::density, Limits::positive(),
                                     "density of the solid explosive", tnt);
  table.add<&Jwl::a>("a", Quantity::pressure, Limits::positive(),
                     "coefficient of the first exponential", tnt);
  table.add<&Jwl::b>("b", Quantity::pressure, Limits::none(),
                     "coefficient of the second exponential", tnt);
  table.add<&Jwl::r1>("r1", Quantity::number, Limits::positive(), "decay of the first exponential",
                      tnt);
  table.add<&Jwl::r2>("r2", Quantity::number, Limits::positive(), "decay of the second exponential",
                      tnt);
  table.add<&Jwl::omega>("omega", Quantity::number, Limits::positive(),
                         "Grueneisen coefficient of the products", tnt);
  table.add<&Jwl::reference_energy>("reference_energy", Quantity::specific_energy,
                                    Limits::positive(), "energy released per mass", tnt);
  table.add<&Jwl::detonation_velocity>("detonation_velocity", Quantity::velocity,
                                       Limits::positive(), "speed of the detonation front", tnt);
}

void add_ideal_gas(std::vector<Entry<MaterialSpec>>& entries) {
  LawTable<IdealGas> table(entries);
  table.add<&IdealGas::reference_density>("reference_density", Quantity::density,
                                          Limits::positive(), "density of the undisturbed gas",
                                          air);
  table.add<&IdealGas::heat_capacity_ratio>("heat_capacity_ratio", Quantity::number,
                                            {.min = 1.0, .min_excluded = true},
                                            "ratio of the heat capacities", air);
  table.add<&IdealGas::reference_energy>("reference_energy", Quantity::specific_energy,
                                         Limits::positive(), "energy of the undisturbed gas", air);
}

std::vector<Entry<MaterialSpec>> make_table() {
  std::vector<Entry<MaterialSpec>> table;
  table.push_back(alternative<MaterialSpec, &MaterialSpec::eos>(
      {.section = Section::material,
       .key = "eos",
       .type = ValueType::choice,
       .presence = Presence::required,
       .names = {Tait::name, WaterPolynomial::name, Jwl::name, IdealGas::name},
       .meaning = "equation of state"}));
  add_tait(table);
  add_water(table);
  add_jwl(table);
  add_ideal_gas(table);
  return table;
}

}  // namespace

std::span<Entry<MaterialSpec> const> material_entries() {
  static std::vector<Entry<MaterialSpec>> const table = make_table();
  return table;
}

}  // namespace moraine
