// The shipped materials: their data, what their equations of state answer, and how cases use them.
#include "setup/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "exact/detonation.hpp"
#include "matter/point/load_path.hpp"
#include "setup/check_strength.hpp"
#include "setup/parameter_table.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

double answer(ShippedMaterial const& material, std::string const& key) {
  Eos const& eos = material.spec.eos;
  double const rho = reference_density(eos);
  double const e = reference_energy(eos);
  if (key == "pressure") return std::visit([&](auto const& l) { return l.pressure(rho, e); }, eos);
  if (key == "sound_speed")
    return std::visit([&](auto const& l) { return l.sound_speed(rho, e); }, eos);
  Detonation const found = chapman_jouguet({eos, rho, e});
  return key == "detonation_velocity" ? found.speed : found.behind.pressure;
}

/// What the rounding of the density, 1e-16, makes of a pressure, with a margin of ten [Pa]: where
/// the pressure is zero no share of it says so.
double rounding_of_pressure(ShippedMaterial const& material) {
  double const c = answer(material, "sound_speed");
  return 1e-15 * reference_density(material.spec.eos) * c * c;
}

TEST(Materials, GiveTheirReferenceState) {
  for (auto const& material : shipped_materials()) {
    EXPECT_GE(material.references.size(), 2u) << material.spec.name;
    for (auto const& reference : material.references) {
      double const found = answer(material, reference.key);
      EXPECT_NEAR(found, reference.value,
                  reference.tolerance * std::abs(reference.value) +
                      (reference.key == "pressure" ? rounding_of_pressure(material) : 0.0))
          << material.spec.name << ' ' << reference.key;
    }
  }
}

TEST(Materials, HaveASourceForEveryValue) {
  ASSERT_FALSE(shipped_materials().empty());
  for (auto const& material : shipped_materials()) {
    EXPECT_FALSE(material.meaning.empty());
    for (auto const& value : material.values) EXPECT_FALSE(value.source.empty()) << value.key;
    for (auto const& reference : material.references) EXPECT_FALSE(reference.source.empty());
  }
}

// What a law starts from in the program and in cases that name only `eos` is the shipped material.
TEST(Materials, AgreeWithTheDefaultsOfTheLaws) {
  auto const constants = [](Eos const& eos) {
    std::vector<double> values;
    MaterialSpec const spec{"", eos};
    for (auto const& entry : material_entries())
      if (auto const value = entry.get(spec); std::holds_alternative<double>(value))
        values.push_back(std::get<double>(value));
    return values;
  };
  EXPECT_EQ(constants(shipped_material("tnt").spec.eos), constants(Jwl{}));
  EXPECT_EQ(constants(shipped_material("water_shock").spec.eos), constants(WaterPolynomial{}));
  EXPECT_EQ(constants(shipped_material("water").spec.eos), constants(Tait{}));
  EXPECT_EQ(constants(shipped_material("air").spec.eos), constants(IdealGas{}));
  EXPECT_EQ(constants(shipped_material("water_us_up").spec.eos), constants(UsUp{}));
}

std::string case_with(std::string const& material) {
  return "space.dimension = 2\nresolution.spacing = 0.1\ntime.end = 1\n[material.m]\n" + material +
         "\n[[region]]\nname = \"r\"\nmaterial = \"m\"\nbox = { min = [0, 0], max = [1, 1] }\n";
}

TEST(Materials, AreUsedAndOverridden) {
  Case const c = parse_case(case_with("use = \"c4\"\nreference_energy = \"5 MJ/kg\""), "case.toml");
  auto const& law = std::get<Jwl>(c.materials[0].eos);
  EXPECT_EQ(law.reference_density, 1601.0);
  EXPECT_EQ(law.r2, 1.4);
  EXPECT_EQ(law.reference_energy, 5e6);
  EXPECT_EQ(c.materials[0].name, "m");
  // The used case says it all by itself.
  std::string const used = used_case(c);
  EXPECT_EQ(used.find("use ="), std::string::npos);
  auto const again = std::get<Jwl>(parse_case(used, "used").materials[0].eos);
  EXPECT_EQ(again.reference_energy, 5e6);
  EXPECT_EQ(again.a, law.a);
}

TEST(Materials, GiveTheirEndInTension) {
  auto const end_of = [](std::string const& more) {
    Case const c = parse_case(case_with("use = \"concrete\"" + more), "case.toml");
    EXPECT_EQ(parse_case(used_case(c), "used").materials[0].tension, c.materials[0].tension);
    return c.materials[0].tension;
  };
  EXPECT_EQ(end_of(""), TensionEnd::spall);
  EXPECT_EQ(end_of("\ntension = \"floor\""), TensionEnd::floor);
  EXPECT_NE(describe(shipped_material("concrete")).find("tension = \"spall\""), std::string::npos);
  EXPECT_EQ(parse_case(case_with("use = \"sand_loose\""), "case.toml").materials[0].tension,
            TensionEnd::floor);
}

/// Compression along x that a shipped solid bears at the end of a path [Pa].
double borne_by(std::string_view name, LoadPath path, double strain) {
  MaterialSpec const& spec = shipped_material(name).spec;
  MaterialElement const element(spec.eos, strength_of(spec.strength));
  return -follow(element, {.path = path, .strain = strain}).back().stress()[0];
}

// Free across, a bar and a plate in plane strain bear the strengths that the pyramid is laid
// through, to the digits of the files; to solve for the stress across takes more off.
TEST(Materials, BrittleOnesBearTheirStrengths) {
  struct Brittle {
    char const* name;
    double compression, tension;  // Pa
  };
  for (Brittle const& solid : {Brittle{"concrete", 40e6, 4e6}, Brittle{"granite", 150e6, 10e6}}) {
    SCOPED_TRACE(solid.name);
    for (LoadPath const path : {LoadPath::triaxial, LoadPath::biaxial}) {
      EXPECT_NEAR(borne_by(solid.name, path, 0.03), solid.compression, 1e-5 * solid.compression);
      EXPECT_NEAR(borne_by(solid.name, path, -0.003), -solid.tension, 1e-5 * solid.tension);
    }
  }
}

TEST(Materials, MistakesOfTheirFilesAreTold) {
  EXPECT_EQ(message_of<InputErrors>([] {
              parse_material(
                  "meaning = \"x\"\neos = \"ideal_gas\"\ncolour = 1\ntension = \"spal\"\n"
                  "[reference_density]\nvalue = \"1 kg/m^2\"\nsource = \"s\"\n"
                  "[heat_capacity_ratio]\nvalue = 1.4\n"
                  "[reference_energy]\nvalue = 2\nsource = \"s\"\n"
                  "[reference.pressure]\nvalue = \"1 Pa\"\nsource = \"s\"\n",
                  "x");
            }),
            "materials/x.toml:3:1: colour: is an unknown key\n"
            "materials/x.toml:4:11: tension: is no end in tension; did you mean \"spall\"?\n"
            "materials/x.toml:6:9: reference_density.value: \"1 kg/m^2\" has another dimension; a "
            "density is expected (kg/m^3)\n"
            "materials/x.toml:8:1: heat_capacity_ratio.source: is missing: a text\n"
            "materials/x.toml:11:9: reference_energy.value: 2 needs a unit\n"
            "materials/x.toml:13:1: reference.pressure.tolerance: is missing: a positive number");
}

TEST(Materials, UnknownNamesGetTheNearest) {
  EXPECT_EQ(message_of<InputErrors>([] { shipped_material("tnd"); }),
            "moraine materials: \"tnd\" is no shipped material; did you mean \"tnt\"?");
}

TEST(Materials, AreDescribedWithSources) {
  std::string const text = describe(shipped_material("tnt"));
  EXPECT_NE(text.find("1630 kg/m^3"), std::string::npos);
  EXPECT_NE(text.find("UCRL-52997"), std::string::npos);
  std::string const list = list_materials();
  for (auto const& material : shipped_materials())
    EXPECT_NE(list.find(material.spec.name), std::string::npos);
}

}  // namespace
}  // namespace moraine
