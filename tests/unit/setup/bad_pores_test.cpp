// Keys of porous materials: what they become, and mistakes with their exact messages.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "base/input_error.hpp"
#include "setup/initial_state.hpp"
#include "setup/materials.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

std::string text_with(std::string const& material) {
  return "space.dimension = 2\nresolution.spacing = 0.1\ntime.end = 1\n[material.m]\n" + material +
         "\n[[region]]\nname = \"r\"\nmaterial = \"m\"\nbox = { min = [0, 0], max = [1, 1] }\n";
}

std::string message_of(std::string const& material) {
  try {
    parse_case(text_with(material), "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

TEST(PorousKeys, AreReadWithUnits) {
  Case const c = parse_case(
      text_with("eos = \"p_alpha\"\nreference_density = \"1.9 g/cm^3\"\nelastic_limit = \"2 MPa\"\n"
                "full_compaction_pressure = \"90 MPa\"\nreference_sound_speed = \"400 m/s\"\n"
                "half_pressure = inf\n"),
      "case.toml");
  auto const& law = std::get<PAlpha>(c.materials[0].eos);
  EXPECT_DOUBLE_EQ(law.reference_density, 1900.0);
  EXPECT_EQ(law.elastic_limit, 2e6);
  EXPECT_EQ(law.full_compaction_pressure, 90e6);
  EXPECT_TRUE(std::isinf(law.half_pressure));
  EXPECT_EQ(law.crush_exponent, 2.0) << "Herrmann's";
  auto const& again = std::get<PAlpha>(parse_case(used_case(c), "used.toml").materials[0].eos);
  EXPECT_TRUE(std::isinf(again.half_pressure));
  EXPECT_EQ(again.full_compaction_pressure, 90e6);
}

TEST(PorousKeys, ShippedMaterialsAreSound) {
  for (ShippedMaterial const& material : shipped_materials()) {
    if (!std::holds_alternative<PAlpha>(material.spec.eos)) continue;
    EXPECT_EQ(message_of("use = \"" + material.spec.name + "\""), "no error");
  }
}

TEST(PorousKeys, MistakesAreTold) {
  std::string const law = "eos = \"p_alpha\"\n";
  EXPECT_EQ(
      message_of(law + "reference_density = 2700"),
      "case.toml:6:21: material.m.reference_density: 2700 leaves no pores: the density of the "
      "porous material, 2700 kg/m^3, is not below that of its solid, 2650 kg/m^3; material "
      "without pores is eos = \"us_up\"");
  EXPECT_EQ(message_of(law + "reference_sound_speed = 4000"),
            "case.toml:6:25: material.m.reference_sound_speed: 4000 makes porous material, 4000 "
            "m/s, as stiff as its solid, 3680 m/s");
  EXPECT_EQ(message_of(law + "elastic_limit = \"80 MPa\""),
            "case.toml:6:17: material.m.elastic_limit: \"80 MPa\" leaves nothing to be crushed: "
            "full compaction at 7.5e+07 Pa is not above the elastic limit, 8e+07 Pa");
  EXPECT_EQ(message_of(law + "full_compaction_pressure = \"500 MPa\""),
            "case.toml:6:28: material.m.full_compaction_pressure: \"500 MPa\" makes unloading give "
            "back more work than crushing took: the crush curve begins as steep as 627.5 m/s, "
            "undisturbed material has 265 m/s; raise reference_sound_speed, or lower "
            "full_compaction_pressure or half_pressure");
  EXPECT_EQ(message_of(law + "least_pressure = \"-1 GPa\""),
            "case.toml:6:18: material.m.least_pressure: \"-1 GPa\" is more tension than the pores "
            "can bear elastically, -1.182e+08 Pa; raise least_pressure towards 0");
  EXPECT_EQ(message_of(law + "least_pressure = \"1 Pa\""),
            "case.toml:6:18: material.m.least_pressure: \"1 Pa\" must be at most 0 Pa");
  EXPECT_EQ(message_of("use = \"dry_sand\"\nreference_sound_speed = 100"),
            "case.toml:6:25: material.m.reference_sound_speed: 100 makes unloading give back more "
            "work than crushing took: the crush curve begins as steep as 263.2 m/s, undisturbed "
            "material has 100 m/s; raise reference_sound_speed, or lower full_compaction_pressure "
            "or half_pressure");
}

// A pressure is that of sand that has never borne more: it lies on the crush curve.
TEST(PorousKeys, PressureOfTheStartCompacts) {
  Eos const sand = shipped_material("dry_sand").spec.eos;
  InitialState initial;
  initial.pressure = 30e6;
  auto const state = initial_state(sand, initial, {}, {});
  ASSERT_TRUE(state);
  auto const& law = std::get<PAlpha>(sand);
  CompactionResponse const at = law.virgin(state->density, state->specific_energy);
  EXPECT_NEAR(at.pressure, 30e6, 1.0);
  EXPECT_NEAR(at.distension, law.crush_curve().distension_at(30e6), 1e-9);
  initial.pressure = -1.0;
  EXPECT_FALSE(initial_state(sand, initial, {}, {})) << "sand bears no tension";
}

}  // namespace
}  // namespace moraine
