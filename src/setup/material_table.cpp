// The table of parameters: materials. An equation of state adds its keys here.
#include <string_view>
#include <vector>

#include "setup/burn_table.hpp"
#include "setup/materials.hpp"
#include "setup/parameter_table.hpp"
#include "setup/strength_table.hpp"
#include "setup/toml.hpp"

namespace moraine {
namespace {

constexpr std::string_view water = "water; Liu and Liu, Smoothed Particle Hydrodynamics (2003)";
constexpr std::string_view tnt =
    "TNT; Dobratz and Crawford, UCRL-52997 (1985); energy of Liu and Liu (2003)";
constexpr std::string_view line =
    "water below 2 km/s, rounded; Marsh, LASL Shock Hugoniot Data (1980)";
constexpr std::string_view sand =
    "dry sand; Laine and Sandvik, 4th Asia-Pacific Conference on Shock and Impact Loads on "
    "Structures (2001) 361";
constexpr std::string_view quartz = "quartz, rounded; materials/dry_sand.toml";
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
                                       Limits::positive(),
                                       "speed of the detonation front; of programmed burn", tnt);
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

// The keys that both forms of Mie-Grueneisen have.
template <class Law>
void add_mie_grueneisen(std::vector<Entry<MaterialSpec>>& entries, std::string_view coefficient) {
  LawTable<Law> table(entries);
  table.template add<&Law::reference_density>("reference_density", Quantity::density,
                                              Limits::positive(), "density at zero compression",
                                              line);
  table.template add<&Law::reference_sound_speed>(
      "reference_sound_speed", Quantity::velocity, Limits::positive(),
      "speed of weak shocks: where the line of shock over particle speed begins", line);
  table.template add<&Law::hugoniot_slope>("hugoniot_slope", Quantity::number,
                                           Limits::not_negative(),
                                           "slope of shock over particle speed", line);
  table.template add<&Law::grueneisen_coefficient>("grueneisen_coefficient", Quantity::number,
                                                   Limits::not_negative(), coefficient, line);
  table.template add<&Law::reference_energy>("reference_energy", Quantity::specific_energy,
                                             Limits::none(), "initial energy");
  table.template add<&Law::least_pressure>(
      "least_pressure", Quantity::pressure, {.infinity_allowed = true},
      "least pressure that the material bears: minus its spall strength; -inf: no floor");
}

void add_linear(std::vector<Entry<MaterialSpec>>& entries) {
  LawTable<Linear> table(entries);
  table.add<&Linear::reference_density>("reference_density", Quantity::density, Limits::positive(),
                                        "density at the background pressure", "water");
  table.add<&Linear::reference_sound_speed>(
      "reference_sound_speed", Quantity::velocity, Limits::positive(),
      "sound speed at any density; ten times the largest velocity is usual", "water");
  table.add<&Linear::background_pressure>("background_pressure", Quantity::pressure, Limits::none(),
                                          "pressure at the reference density");
  table.add<&Linear::reference_energy>("reference_energy", Quantity::specific_energy,
                                       Limits::none(), "initial energy; no effect on the pressure");
  table.add<&Linear::least_pressure>("least_pressure", Quantity::pressure,
                                     {.infinity_allowed = true},
                                     "least pressure that the liquid bears; -inf: no floor");
}

void add_pores(LawTable<PAlpha>& table) {
  table.add<&PAlpha::reference_density>("reference_density", Quantity::density, Limits::positive(),
                                        "density of the undisturbed porous material", sand);
  table.add<&PAlpha::reference_sound_speed>("reference_sound_speed", Quantity::velocity,
                                            Limits::positive(),
                                            "sound speed of the undisturbed porous material", sand);
  table.add<&PAlpha::elastic_limit>("elastic_limit", Quantity::pressure, Limits::not_negative(),
                                    "pressure from which on pores are crushed");
  table.add<&PAlpha::full_compaction_pressure>(
      "full_compaction_pressure", Quantity::pressure, Limits::positive(),
      "pressure at which no pore is left", "near the sand of Laine and Sandvik below 15 MPa");
  table.add<&PAlpha::crush_exponent>(
      "crush_exponent", Quantity::number, {.min = 1.0},
      "exponent of the crush curve: how pores close between the two pressures",
      "Herrmann, J. Appl. Phys. 40 (1969) 2490");
  table.add<&PAlpha::half_pressure>(
      "half_pressure", Quantity::pressure,
      {.min = 0.0, .min_excluded = true, .infinity_allowed = true},
      "gives the crush curve a long tail: with crush_exponent = 1 about half of the pores are left "
      "this far above the elastic limit; inf: no tail");
}

void add_p_alpha(std::vector<Entry<MaterialSpec>>& entries) {
  LawTable<PAlpha> table(entries);
  add_pores(table);
  table.add<&PAlpha::solid_density>("solid_density", Quantity::density, Limits::positive(),
                                    "density of the solid, the grains", quartz);
  table.add<&PAlpha::solid_sound_speed>(
      "solid_sound_speed", Quantity::velocity, Limits::positive(),
      "of the solid: where the line of shock over particle speed begins", quartz);
  table.add<&PAlpha::hugoniot_slope>("hugoniot_slope", Quantity::number, Limits::not_negative(),
                                     "of the solid: slope of shock over particle speed", quartz);
  table.add<&PAlpha::grueneisen_coefficient>(
      "grueneisen_coefficient", Quantity::number, Limits::not_negative(),
      "of the solid, at its density; it falls as 1 / density", quartz);
  table.add<&PAlpha::reference_energy>("reference_energy", Quantity::specific_energy,
                                       Limits::none(), "initial energy");
  table.add<&PAlpha::least_pressure>(
      "least_pressure", Quantity::pressure, {.max = 0.0},
      "least pressure that the material bears: minus its spall strength");
}

// In the order of the list Eos.
std::vector<std::string_view> law_names() {
  return {Tait::name, WaterPolynomial::name, Jwl::name,   IdealGas::name, MieGrueneisen::name,
          UsUp::name, Linear::name,          PAlpha::name};
}

// The law of a material file, known before the file is read with this very table.
std::string_view law_of(EmbeddedText const& material) {
  std::string const law = toml::parse(material.text)["eos"].value_or(std::string{});
  for (auto const name : law_names())
    if (name == law) return name;
  return {};
}

// A shipped material: its law and all its constants, of which the file may override some.
Entry<MaterialSpec> use() {
  Parameter parameter{.section = Section::material,
                      .key = "use",
                      .type = ValueType::choice,
                      .preset_note = "none; eos and its constants are given instead",
                      .meaning =
                          "a shipped material that gives equation of state and constants; "
                          "the other keys override single constants",
                      .decides = "eos"};
  for (auto const& material : material_texts()) {
    parameter.names.push_back(material.name);
    parameter.decided.push_back(law_of(material));
  }
  return {std::move(parameter),
          [](MaterialSpec& material, Value const& value) {
            MaterialSpec const& shipped =
                shipped_materials()[static_cast<std::size_t>(std::get<int>(value))].spec;
            material.eos = shipped.eos;
            material.strength = shipped.strength;
            material.tension = shipped.tension;
          },
          [](MaterialSpec const&) { return Value(); }};  // eos and its constants say it all
}

std::vector<Entry<MaterialSpec>> make_table() {
  std::vector<Entry<MaterialSpec>> table;
  table.push_back(use());
  table.push_back(alternative<MaterialSpec, &MaterialSpec::eos>(
      {.section = Section::material,
       .key = "eos",
       .type = ValueType::choice,
       .presence = Presence::required,
       .preset_note = "none; must be given where use is not",
       .names = law_names(),
       .meaning = "equation of state"}));
  add_tait(table);
  add_water(table);
  add_jwl(table);
  add_ideal_gas(table);
  add_mie_grueneisen<MieGrueneisen>(table, "Grueneisen coefficient, the same at any density");
  add_mie_grueneisen<UsUp>(
      table, "Grueneisen coefficient at the reference density; it falls as 1 / density");
  add_linear(table);
  add_p_alpha(table);
  table.push_back(member<MaterialSpec, &MaterialSpec::dynamic_viscosity>(
      {.section = Section::material,
       .key = "dynamic_viscosity",
       .quantity = Quantity::dynamic_viscosity,
       .preset = 0.0,
       .limits = Limits::not_negative(),
       .meaning = "viscosity of a Newtonian fluid; counts where numerics.physical_viscosity is "
                  "given",
       .source = "water at 20 degC has 1 mPa s"}));
  table.push_back(member<MaterialSpec, &MaterialSpec::penalty_group>(
      {.section = Section::material,
       .key = "penalty_group",
       .type = ValueType::text,
       .preset_note = "the name of the material: it repels every other one; of materials with a "
                      "strength \"solids\": they are bonded",
       .meaning = "materials of one group do not repel each other where numerics.penalty.strength "
                  "is given"}));
  add_burn_entries(table);
  add_strength_entries(table);
  return table;
}

}  // namespace

std::span<Entry<MaterialSpec> const> material_entries() {
  static std::vector<Entry<MaterialSpec>> const table = make_table();
  return table;
}

}  // namespace moraine
