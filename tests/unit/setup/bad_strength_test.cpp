// Strength, tension and absorbing layers of a case: what they become, and mistakes with their
// messages.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/case_report.hpp"
#include "setup/check_absorbing.hpp"
#include "setup/check_strength.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

std::string text_with(std::string const& material, std::string const& in_space = "") {
  return R"(
[space]
dimension = 2
domain = { min = [-1, -1], max = [2, 2] }
)" + in_space +
         R"(
[resolution]
spacing = "10 cm"
[time]
end = "1 ms"
[material.soil]
)" + material +
         R"(
[[region]]
name = "ground"
material = "soil"
box = { min = [0, 0], max = [1, 1] }
)";
}

std::string message_of(std::string const& text) {
  try {
    parse_case(text, "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

testing::AssertionResult says(std::string const& text, std::string const& part) {
  std::string const message = message_of(text);
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << message << "\ndoes not say: " << part;
}

TEST(StrengthOfCase, ComesFromTheShippedMaterialAndItsOwnKeys) {
  Case const c =
      parse_case(text_with("use = \"sand_loose\"\nstrength.yield_slope = 0.3"), "case.toml");
  auto const law = std::get<DruckerPrager>(strength_of(c.materials.front().strength));
  EXPECT_EQ(law.shear_modulus, 63.58e6);
  EXPECT_EQ(law.yield_slope, 0.3);
  EXPECT_EQ(law.shear_strength, 0.2e6);
  EXPECT_TRUE(build_model(c).has_solids());
}

TEST(StrengthOfCase, IsToldInTheUsedCaseAndReadsBack) {
  Case const c =
      parse_case(text_with("eos = \"linear\"\nleast_pressure = \"-1 kPa\"\ntension = \"spall\"\n"
                           "strength = { kind = \"mohr_coulomb\", shear_modulus = \"2 MPa\", "
                           "friction_angle = \"31 deg\", cohesion = \"1 kPa\" }"),
                 "case.toml");
  Case const again = parse_case(used_case(c), "used.toml");
  auto const law = std::get<MohrCoulomb>(strength_of(again.materials.front().strength));
  EXPECT_NEAR(law.friction_angle, 31.0 * std::acos(-1.0) / 180.0, 1e-12);
  EXPECT_EQ(law.cohesion, 1e3);
  EXPECT_EQ(again.materials.front().tension, TensionEnd::spall);
}

TEST(StrengthOfCase, WithoutAKindIsNone) {
  Case const c = parse_case(text_with("eos = \"linear\""), "case.toml");
  EXPECT_EQ(c.materials.front().strength.kind, StrengthKind::none);
  EXPECT_FALSE(build_model(c).has_solids());
}

TEST(BadStrength, EachMistakeHasItsMessage) {
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength.kind = \"drucker_prager\""),
                   "material.soil.strength.shear_modulus: is missing: drucker_prager needs it"));
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength.kind = \"drucker_prager\""),
                   "material.soil.strength.yield_slope: is missing"));
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength = { kind = \"elastic\", shear_modulus = "
                             "\"1 MPa\", cohesion = \"1 kPa\" }"),
                   "does not belong to strength.kind = \"elastic\""));
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength.cohesion = \"1 kPa\""),
                   "does not belong to strength.kind = \"none\""));
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength = { kind = \"mohr_colomb\" }"),
                   "did you mean \"mohr_coulomb\"?"));
  EXPECT_TRUE(says(text_with("eos = \"linear\"\nstrength = { kind = \"elastic\", shear_modulus = "
                             "\"1 m\" }"),
                   "shear_modulus"));
  EXPECT_TRUE(
      says(text_with("eos = \"jwl\"\nburn = { kind = \"programmed\", ignition_points = [[0, "
                     "0]] }\nstrength = { kind = \"elastic\", shear_modulus = 1e6 }"),
           "is given for an explosive that burns"));
  EXPECT_TRUE(says(text_with("eos = \"tait\"\ntension = \"spall\""),
                   "needs a least pressure below zero, where it parts"));
  EXPECT_TRUE(says(text_with("eos = \"us_up\"\ntension = \"spall\""),
                   "needs a least pressure below zero, where it parts"));
}

TEST(BadStrength, AbsorbingLayersThatCannotBe) {
  std::string const soil = "eos = \"linear\"";
  EXPECT_TRUE(says(text_with(soil, "absorbing = { sides = [\"z-\"], thickness = 1 }"), "z-"));
  EXPECT_TRUE(says(text_with(soil, "absorbing = { sides = [\"x-\"] }"),
                   "space.absorbing.thickness: is missing"));
  EXPECT_TRUE(says(text_with(soil, "absorbing = { sides = [\"x-\"], thickness = \"20 cm\" }"),
                   "is less than four spacings"));
  EXPECT_TRUE(says(text_with(soil,
                             "periodic = [\"x\"]\nabsorbing = { sides = [\"x-\"], "
                             "thickness = 1 }"),
                   "has the side x- of a periodic axis"));
  EXPECT_TRUE(says(text_with(soil,
                             "symmetry = [\"x-\"]\nabsorbing = { sides = [\"x-\"], "
                             "thickness = 1 }"),
                   "has the side x-, a symmetry plane"));
}

// With 3 alpha of one no compression in plane strain is too much for the cone.
TEST(StrengthWarning, AConeTooSteepForPlaneStrainIsTold) {
  auto const doubts = [](std::string const& slope) -> std::string {
    std::vector<InputProblem> warnings;
    add_strength_warnings(
        parse_case(text_with("eos = \"mie_grueneisen\"\nstrength = { kind = \"drucker_prager\", "
                             "shear_modulus = 1e7, shear_strength = 0, yield_slope = " +
                             slope + " }"),
                   "case.toml"),
        warnings);
    return warnings.empty() ? "none" : InputErrors(warnings).what();
  };
  EXPECT_EQ(doubts("0.333"), "none");
  EXPECT_EQ(
      doubts("0.5"),
      "case.toml:12:94: material.soil.strength.yield_slope: 0.5 lets plane strain bear any "
      "compression: three times it is 1.5, and from one on it never yields there; take kind = "
      "\"mohr_coulomb\"");
}

// Layers that swallow the case, and what lies in them.
TEST(AbsorbingWarnings, LayersThatAreTooThickAreTold) {
  auto const told = [](std::string const& sides, std::string const& thickness,
                       std::string const& gauge) {
    Case const c =
        parse_case(text_with("eos = \"linear\"", "absorbing = { sides = [" + sides +
                                                     "], thickness = " + thickness + " }") +
                       "[[gauge]]\nname = \"g\"\nposition = " + gauge + "\n",
                   "case.toml");
    std::vector<InputProblem> warnings;
    add_absorbing_warnings(c, build_model(c), warnings);
    return warnings.empty() ? std::string("none") : std::string(InputErrors(warnings).what());
  };
  EXPECT_EQ(told("\"x-\"", "0.4", "[0.5, 0.5]"), "none");
  EXPECT_NE(told("\"x-\"", "0.4", "[0.3, 0.5]").find("readings mean nothing"), std::string::npos);
  EXPECT_NE(told("\"x-\", \"x+\"", "3", "[0.5, 0.5]").find("makes layers of 100 % of soil"),
            std::string::npos);
}

// More tension than the cone has would be borne without shear.
TEST(StrengthWarning, AFloorBelowTheApexIsTold) {
  Case const c = parse_case(
      text_with(
          "eos = \"mie_grueneisen\"\nleast_pressure = \"-1 MPa\"\nstrength = { kind = "
          "\"drucker_prager\", shear_modulus = 1e7, yield_slope = 0.25, shear_strength = 3e4 }"),
      "case.toml");
  EXPECT_NE(to_text(report_case(c)).find("beyond the apex of its yield surface"),
            std::string::npos);
  Case const good = parse_case(text_with("use = \"sand_loose\""), "case.toml");
  EXPECT_EQ(to_text(report_case(good)).find("apex"), std::string::npos);
}

}  // namespace
}  // namespace moraine
