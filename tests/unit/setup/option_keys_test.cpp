// Keys of the optional terms: what they become, mistakes and doubts with their exact messages.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/check_options.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {
namespace {

std::string text_with(std::string const& numerics, std::string const& material = "") {
  return "space.dimension = 2\nresolution.spacing = 0.1\ntime.end = 1\n[numerics]\n" + numerics +
         "\n[material.m]\neos = \"tait\"\n" + material +
         "\n[[region]]\nname = \"r\"\nmaterial = \"m\"\nbox = { min = [0, 0], max = [1, 1] }\n";
}

std::string message_of(std::string const& numerics, std::string const& material = "") {
  try {
    parse_case(text_with(numerics, material), "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

std::string doubts_of(std::string const& numerics, std::string const& material = "") {
  std::vector<InputProblem> warnings;
  add_option_warnings(parse_case(text_with(numerics, material), "case.toml"), warnings);
  return warnings.empty() ? "none" : InputErrors(warnings).what();
}

TEST(OptionKeys, ReachTheSweep) {
  Case const c =
      parse_case(text_with("physical_viscosity = \"morris\"\nxsph = 0.5\nshifting = 2\n"
                           "gradient_correction = \"bonet_lok\"\ndensity_diffusion = 0.1\n"
                           "density_diffusion_form = \"gradient\"\n"
                           "penalty = { strength = 1e5, repulsion = 6, attraction = 4 }",
                           "dynamic_viscosity = \"1 mPa s\""),
                 "case.toml");
  Model const model = build_model(c);
  EXPECT_EQ(model.materials[0].dynamic_viscosity, 1e-3);
  OptionParameters const p = option_parameters(model);
  EXPECT_EQ(p.viscosity, ViscosityForm::morris);
  EXPECT_EQ(p.xsph, 0.5);
  EXPECT_EQ(p.shifting, 2.0);
  EXPECT_TRUE(p.corrected_gradient);
  EXPECT_EQ(p.gradient_diffusion, 0.1);
  EXPECT_EQ(p.penalty_strength, 1e5);
  EXPECT_EQ(p.penalty_repulsion, 6);
  EXPECT_EQ(p.penalty_attraction, 4);
  EXPECT_DOUBLE_EQ(p.penalty_range * 2.0 * 0.12, 0.1) << "one spacing at h of 1.2";
  // What a run writes down reads back to the same.
  Model const again = build_model(parse_case(used_case(c), "used.toml"));
  EXPECT_EQ(option_parameters(again).penalty_range, p.penalty_range);
  EXPECT_EQ(again.materials[0].dynamic_viscosity, 1e-3);
}

TEST(OptionKeys, PenaltyGroups) {
  auto const with = [](std::string const& one, std::string const& other) {
    return "space.dimension = 2\nresolution.spacing = 0.1\ntime.end = 1\n"
           "numerics.penalty.strength = 1\n[material.sand]\neos = \"tait\"\n" +
           one + "\n[material.clay]\neos = \"tait\"\n" + other +
           "\n[[region]]\nname = \"r\"\nmaterial = \"sand\"\n"
           "box = { min = [0, 0], max = [1, 1] }\n";
  };
  auto const doubts = [](Case const& c) -> std::string {
    std::vector<InputProblem> warnings;
    add_option_warnings(c, warnings);
    return warnings.empty() ? "none" : InputErrors(warnings).what();
  };
  std::string const soil = "penalty_group = \"soil\"";
  Case const apart = parse_case(with("", soil), "case.toml");
  EXPECT_EQ(build_model(apart).materials[0].penalty_group, "sand") << "by default its own";
  EXPECT_EQ(build_model(apart).materials[1].penalty_group, "soil");
  EXPECT_EQ(doubts(apart), "none");
  Case const again = parse_case(used_case(apart), "used.toml");
  EXPECT_EQ(again.materials[0].penalty_group, "");
  EXPECT_EQ(again.materials[1].penalty_group, "soil");
  EXPECT_EQ(doubts(parse_case(with(soil, soil), "case.toml")),
            std::string("case.toml:4:29: numerics.penalty.strength: 1 keeps nothing apart: all "
                        "materials are of one penalty_group"));
}

TEST(OptionKeys, SolidsAreBonded) {
  MaterialSpec sand{"sand", Linear{}}, rock{"rock", Linear{}}, water{"water", Linear{}};
  sand.strength.kind = rock.strength.kind = StrengthKind::elastic;
  EXPECT_EQ(sand.group(), rock.group());
  EXPECT_NE(sand.group(), water.group());
  rock.penalty_group = "boulder";
  EXPECT_NE(sand.group(), rock.group());
}

TEST(OptionKeys, ACaseWithoutThemHasNoBackend) {
  EXPECT_EQ(make_options_of(build_model(parse_case(text_with(""), "case.toml"))), nullptr);
  EXPECT_NE(
      make_options_of(build_model(parse_case(text_with("density = \"summation\""), "c.toml"))),
      nullptr);
}

TEST(OptionKeys, Mistakes) {
  EXPECT_EQ(
      message_of("physical_viscosity = \"morris\""),
      "case.toml:5:22: numerics.physical_viscosity: \"morris\" needs a material that has one; "
      "give material.NAME.dynamic_viscosity");
  EXPECT_EQ(
      message_of("penalty = { strength = 1e5, repulsion = 6, attraction = 6 }"),
      "case.toml:5:57: numerics.penalty.attraction: 6 makes particles attract each other; the "
      "exponent of the repulsion is larger than that of the attraction");
  EXPECT_EQ(message_of("penalty = { strength = 1e5, repulsion = 4 }"),
            "case.toml:5:41: numerics.penalty.repulsion: 4 makes particles attract each other; the "
            "exponent of the repulsion is larger than that of the attraction");
  EXPECT_EQ(message_of("", "dynamic_viscosity = \"1 m^2/s\""),
            "case.toml:8:21: material.m.dynamic_viscosity: \"1 m^2/s\" has another "
            "dimension; a dynamic viscosity is expected (Pa s)");
  EXPECT_EQ(message_of("xsph = 2"), "case.toml:5:8: numerics.xsph: 2 must be between 0 and 1");
}

TEST(OptionKeys, CorrectedGradientsRefuseWallsThatTurn) {
  auto const message = [](std::string const& motion) {
    return message_of(
        "gradient_correction = \"bonet_lok\"",
        "[[wall]]\nname = \"tank\"\ncontainer = { min = [0, 0], max = [1, 2] }\n" + motion);
  };
  EXPECT_EQ(message("motion.rotation = \"0.1 * sin(t)\""),
            "case.toml:5:23: numerics.gradient_correction: \"bonet_lok\" knows no walls that turn, "
            "as tank does; leave it out");
  EXPECT_EQ(message("motion.translation = [\"0.1 * t\", \"0\"]"), "no error");
  EXPECT_EQ(message(""), "no error");
}

TEST(OptionKeys, Doubts) {
  EXPECT_EQ(doubts_of("xsph = 0.5"), "none");
  EXPECT_EQ(doubts_of("", "dynamic_viscosity = 1e-3"),
            "case.toml:8:21: material.m.dynamic_viscosity: 1e-3 counts for nothing; give "
            "numerics.physical_viscosity");
  EXPECT_EQ(doubts_of("penalty = { strength = 1e5, range = \"smoothing_length\" }"),
            "case.toml:5:24: numerics.penalty.strength: 1e5 keeps nothing apart: the case has one "
            "material\n"
            "case.toml:5:37: numerics.penalty.range: \"smoothing_length\" pushes materials apart "
            "that are at rest on their lattice; take \"spacing\"");
  EXPECT_EQ(
      doubts_of("density_diffusion_form = \"gradient\""),
      "case.toml:5:26: numerics.density_diffusion_form: \"gradient\" counts for nothing; give "
      "numerics.density_diffusion, 0.1 is usual");
  EXPECT_EQ(doubts_of("density = \"summation\"\ndensity_diffusion = 0.1"),
            "case.toml:6:21: numerics.density_diffusion: 0.1 counts for nothing where density is a "
            "sum over neighbours");
  EXPECT_EQ(doubts_of("gradient_correction = \"bonet_lok\""),
            "case.toml:5:23: numerics.gradient_correction: \"bonet_lok\" blows up by itself where "
            "motion lasts; give numerics.shifting, 20 is usual");
  EXPECT_EQ(doubts_of("gradient_correction = \"bonet_lok\"\nshifting = 20"), "none");
}

}  // namespace
}  // namespace moraine
