// Keys of burning explosives: what they become, and mistakes with their exact messages.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "setup/check_burn.hpp"
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

MaterialSpec material_of(std::string const& material) {
  return parse_case(text_with(material), "case.toml").materials[0];
}

TEST(BurnKeys, TakeTheirDefaultsFromTheExplosive) {
  MaterialSpec const m = material_of(
      "use = \"tnt_liu_liu\"\nburn = { kind = \"programmed\", ignition_points = [[0.5, \"2 cm\"]] "
      "}");
  Burn const burn = burn_of(m, 0.1);
  EXPECT_EQ(burn.law.detonation_velocity, 6930.0) << "of the material";
  EXPECT_NEAR(burn.law.cj_volume, 0.731773, 1e-5) << "Dobratz's TNT with the energy of Liu and Liu";
  EXPECT_DOUBLE_EQ(burn.law.width, 0.15);
  EXPECT_EQ(burn.law.reference_density, 1630.0);
  ASSERT_EQ(burn.ignition.points.size(), 1U);
  EXPECT_EQ(burn.ignition.points[0], (Ignition::Place{0.5, 0.02, 0.0}));
  EXPECT_EQ(burn.ignition.delay, 0.0);
}

// Of an ideal gas with much energy: D^2 = 2 (gamma^2 - 1) e, V = gamma / (gamma + 1); Fickett and
// Davis, Detonation (1979), chapter 2.
TEST(BurnKeys, KnowTheDetonationOfAnIdealGas) {
  MaterialSpec const m = material_of(
      "eos = \"ideal_gas\"\nreference_density = 1630\nheat_capacity_ratio = 2.7\n"
      "reference_energy = 4.29e6\n"
      "burn = { kind = \"programmed\", ignition_points = [[0, 0]], width_in_spacings = 3 }");
  EXPECT_NEAR(*m.burn.detonation_velocity, std::sqrt(2.0 * (2.7 * 2.7 - 1.0) * 4.29e6), 0.1);
  EXPECT_NEAR(*m.burn.cj_volume, 2.7 / 3.7, 1e-5);
  EXPECT_DOUBLE_EQ(burn_of(m, 0.1).law.width, 0.3);
}

TEST(BurnKeys, ReadLinesAndPlanes) {
  MaterialSpec const m = material_of(
      "use = \"tnt\"\nburn.kind = \"programmed\"\nburn.delay = \"3 us\"\n"
      "burn.ignition_line = { from = [0, 0], to = [0, 1] }\n"
      "burn.ignition_plane = { point = [2, 0], normal = [1, 1] }\n"
      "burn.detonation_velocity = \"7 km/s\"\nburn.cj_volume = 0.75");
  Burn const burn = burn_of(m, 0.1);
  EXPECT_EQ(burn.law.detonation_velocity, 7000.0);
  EXPECT_EQ(burn.law.cj_volume, 0.75);
  EXPECT_EQ(burn.ignition.delay, 3e-6);
  EXPECT_DOUBLE_EQ(burn.ignition.distance({0.3, 0.5, 0.0}), 0.3);
  EXPECT_DOUBLE_EQ(burn.ignition.distance({1.5, 0.5, 0.0}), 0.0);
}

TEST(BurnKeys, AreInTheUsedCase) {
  Case const c = parse_case(
      text_with(
          "use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = [[0, 0], [1, 1]], "
          "delay = 1e-6, ignition_line = { from = [0, 0], to = [0, 1] } }"),
      "case.toml");
  std::string const text = used_case(c);
  EXPECT_NE(text.find("burn.ignition_points = [[0.0, 0.0], [1.0, 1.0]]"), std::string::npos)
      << text;
  EXPECT_NE(text.find("burn.cj_volume = 0.73"), std::string::npos) << text;
  EXPECT_EQ(used_case(parse_case(text, "used.toml")), text);
  std::string const plain = used_case(parse_case(text_with("use = \"tnt\""), "case.toml"));
  EXPECT_EQ(plain.find("burn"), std::string::npos) << plain;
}

TEST(BurnKeys, MistakesAreNamed) {
  EXPECT_EQ(message_of("use = \"water_shock\"\nburn = { kind = \"programmed\", ignition_points = "
                       "[[0, 0]] }"),
            "case.toml:6:17: material.m.burn.kind: \"programmed\" needs products of an explosive, "
            "eos = \"jwl\" or \"ideal_gas\"");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn.kind = \"programed\""),
            "case.toml:6:13: material.m.burn.kind: \"programed\" is not a known name; did you mean "
            "\"programmed\"?");
  EXPECT_EQ(
      message_of("use = \"tnt\"\nburn.kind = \"programmed\""),
      "case.toml:6:13: material.m.burn.kind: \"programmed\" needs a place where the charge is "
      "lit; give burn.ignition_points, burn.ignition_line or burn.ignition_plane");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn.delay = 1"),
            "case.toml:6:6: material.m.burn.delay: does not belong to burn.kind = "
            "\"instantaneous\"");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = [] }"),
            "case.toml:6:49: material.m.burn.ignition_points: [] holds no point");
  EXPECT_EQ(
      message_of("use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = [[0, 0, 0]] }"),
      "case.toml:6:50: material.m.burn.ignition_points: [0, 0, 0] has 3 components; 2 expected "
      "(space.dimension)");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = [0, 0] }"),
            "case.toml:6:49: material.m.burn.ignition_points: [0, 0] is a list; a list of points, "
            "[[x, y], ...], is expected");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn.kind = \"programmed\"\n"
                       "burn.ignition_line = { from = [0, 0] }"),
            "case.toml:7:22: material.m.burn.ignition_line.to: is missing: its end");
  EXPECT_EQ(message_of("use = \"tnt\"\nburn.kind = \"programmed\"\n"
                       "burn.ignition_plane = { point = [0, 0], normal = [0, 0] }"),
            "case.toml:7:50: material.m.burn.ignition_plane.normal: [0, 0] has no length");
  EXPECT_EQ(
      message_of("use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = [[0, 0]], "
                 "cj_volume = 1.2, detonation_velocity = 0, width_in_spacings = \"2 m\" }"),
      "case.toml:6:71: material.m.burn.cj_volume: 1.2 must be between 0.1 and 0.99\n"
      "case.toml:6:98: material.m.burn.detonation_velocity: 0 must be greater than 0 m/s\n"
      "case.toml:6:121: material.m.burn.width_in_spacings: \"2 m\" is a length; a plain number "
      "is expected");
  EXPECT_EQ(
      message_of("eos = \"jwl\"\nb = \"-500 GPa\"\nburn = { kind = \"programmed\", "
                 "ignition_points = [[0, 0]] }"),
      "case.toml:7:17: material.m.burn.kind: \"programmed\" finds no Chapman-Jouguet state for "
      "the constants of the material; give burn.cj_volume and burn.detonation_velocity");
}

TEST(BurnKeys, FrontsThatTheirProductsDoNotDriveAreDoubtful) {
  auto const warnings_of = [](std::string const& velocity) {
    std::vector<InputProblem> warnings;
    add_burn_warnings(
        parse_case(text_with("use = \"tnt\"\nburn = { kind = \"programmed\", ignition_points = "
                             "[[0, 0]], detonation_velocity = " +
                             velocity + " }"),
                   "case.toml"),
        warnings);
    return warnings;
  };
  EXPECT_TRUE(warnings_of("6930").empty());
  auto const warnings = warnings_of("8000");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(format(warnings[0]),
            "case.toml:6:81: material.m.burn.detonation_velocity: 8000 makes the front run at 8000 "
            "m/s; products with these constants drive a detonation at 6929 m/s");
}

TEST(BadMatter, FloorsAndLimitsAreNamed) {
  EXPECT_EQ(message_of("eos = \"linear\"\nleast_pressure = inf"),
            "case.toml:6:18: material.m.least_pressure: inf must be finite");
  EXPECT_EQ(message_of("eos = \"linear\"\nleast_pressure = -inf"), "no error");
  EXPECT_EQ(message_of("eos = \"us_up\"\nhugoniot_slope = -1"),
            "case.toml:6:18: material.m.hugoniot_slope: -1 must be at least 0");
  EXPECT_EQ(message_of("eos = \"us_up\"\nhugoniot_slop = 1.5"),
            "case.toml:6:1: material.m.hugoniot_slop: is an unknown key; did you mean "
            "\"hugoniot_slope\"?");
  EXPECT_EQ(message_of("eos = \"mie_grueneisen\"\nexponent = 7"),
            "case.toml:6:1: material.m.exponent: does not belong to eos = \"mie_grueneisen\"");
  std::string text = text_with("eos = \"us_up\"");
  try {
    parse_case(text + "density = 2400\n", "case.toml");
    ADD_FAILURE() << "no error";
  } catch (InputErrors const& errors) {
    EXPECT_STREQ(errors.what(),
                 "case.toml:10:11: region.r.density: 2400 is not below 2328.67 kg/m^3, which no "
                 "shock in \"m\" reaches (s eta = 1)");
  }
}

}  // namespace
}  // namespace moraine
