// Regions with lattices of their own: masses, places, sizes, and what is said about them.
#include "setup/region_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/case_report.hpp"
#include "setup/case_size.hpp"
#include "setup/explain_step.hpp"
#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "step/simulation_setup.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

Point all(double value, int dimension) {
  Point point{};
  std::fill_n(point.begin(), dimension, value);
  return point;
}

/// A charge of TNT in the middle of water, whose particles have its masses.
Case charge_in_water(int dimension, LatticeName lattice = LatticeName::square) {
  Case c;
  c.file = "case.toml";
  c.dimension = dimension;
  c.lattice = lattice;
  c.numerics.spacing = 0.05;
  c.materials = {{"water", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"sea", "water", Box{all(-1, dimension), all(1, dimension)}, {}},
               {"charge", "tnt", Box{all(-0.4, dimension), all(0.4, dimension)}, {}}};
  c.regions[1].equal_mass_with = "sea";
  c.domain = *default_domain(c);
  return c;
}

std::vector<Seed> of_region(std::vector<Seed> const& seeds, std::size_t region) {
  std::vector<Seed> found;
  std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(found),
               [&](Seed const& seed) { return seed.region == region; });
  return found;
}

double mass_of(std::vector<Seed> const& seeds) {
  double sum = 0.0;
  for (Seed const& seed : seeds) sum += seed.mass;
  return sum;
}

class EqualMasses : public testing::TestWithParam<std::tuple<int, LatticeName>> {};

// One product and one quotient more than the other mass: three roundings.
TEST_P(EqualMasses, HoldToRounding) {
  auto const [dimension, lattice] = GetParam();
  Case const c = charge_in_water(dimension, lattice);
  auto const seeds = fill_regions(c);
  double const mass = seeds.front().mass;
  ASSERT_EQ(seeds.front().region, 0U);
  ASSERT_FALSE(of_region(seeds, 1).empty());
  for (Seed const& seed : seeds) ASSERT_NEAR(seed.mass, mass, 4e-16 * mass) << seed.region;
  double const spacing = lattices_of_regions(c)[1].spacing;
  double const nominal = std::pow(lattices_of_regions(c)[0].volume, 1.0 / dimension);
  EXPECT_NEAR(spacing, nominal * std::pow(1000.0 / 1630.0, 1.0 / dimension), 1e-15);
  EXPECT_EQ(finest_spacing(c), spacing);
}

// The lattice's rule: along each axis the layers nearest to the length of the box.
TEST_P(EqualMasses, FillTheBoxToHalfALayerOnEachAxis) {
  auto const [dimension, lattice] = GetParam();
  Case const c = charge_in_water(dimension, lattice);
  auto const charge = of_region(fill_regions(c), 1);
  Lattice const own = lattices_of_regions(c)[1];
  double mass = 1630.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const layer = axis == 0 ? own.edge[0] : own.layer(axis);
    double const unit = lattice == LatticeName::square || axis > 0 ? own.layer(axis) : layer;
    mass *= std::round(0.8 / unit) * unit;
    double low = 1.0, high = -1.0;
    for (Seed const& seed : charge) {
      low = std::min(low, seed.position[axis]);
      high = std::max(high, seed.position[axis]);
    }
    EXPECT_NEAR(low, -high, 1e-14) << "a symmetric charge";
  }
  if (lattice == LatticeName::square) {
    EXPECT_NEAR(mass_of(charge), mass, 1e-12 * mass);
  }
  double const box = 1630.0 * std::pow(0.8, dimension);
  double const rule = std::pow(1.0 + 0.5 * own.edge[0] / 0.8, dimension) - 1.0;
  EXPECT_NEAR(mass_of(charge), box, rule * box);
}

INSTANTIATE_TEST_SUITE_P(Lattices, EqualMasses,
                         testing::Values(std::tuple(1, LatticeName::square),
                                         std::tuple(2, LatticeName::square),
                                         std::tuple(3, LatticeName::square),
                                         std::tuple(2, LatticeName::hexagonal),
                                         std::tuple(3, LatticeName::hexagonal)));

TEST(RegionLattice, TakesTheDensityThatThePressureAsksFor) {
  Case c = charge_in_water(2);
  for (RegionSpec& region : c.regions) region.initial.pressure = 5e8;
  auto const seeds = fill_regions(c);
  for (Seed const& seed : seeds) {
    EXPECT_NE(seed.density, seed.material == 0 ? 1000.0 : 1630.0);
    ASSERT_NEAR(seed.mass, seeds.front().mass, 4e-16 * seed.mass);
  }
}

TEST(RegionLattice, FollowsAChainOfEqualMasses) {
  Case c = charge_in_water(2);
  c.regions.push_back({"booster", "tnt", Box{all(-0.2, 2), all(0.2, 2)}, {}});
  c.regions[2].initial.density = 1800.0;
  c.regions[2].equal_mass_with = "charge";
  auto const seeds = fill_regions(c);
  for (Seed const& seed : seeds) ASSERT_NEAR(seed.mass, 2.5, 4e-15) << seed.region;
  c.regions[0].equal_mass_with = "booster";
  EXPECT_THROW(lattices_of_regions(c), std::invalid_argument);
}

TEST(RegionLattice, FillsWholeBoxesExactlyWithPointsInTheMiddleOfTheirCells) {
  Case c = charge_in_water(2);
  c.regions[1].equal_mass_with.clear();
  c.regions[1].spacing = 0.025;
  auto const seeds = fill_regions(c);
  auto const charge = of_region(seeds, 1);
  ASSERT_EQ(charge.size(), 32U * 32U);
  EXPECT_NEAR(charge[0].position[0], -0.4 + 0.0125, 1e-15);
  EXPECT_NEAR(mass_of(charge), 1630.0 * 0.64, 1e-9);
  EXPECT_EQ(of_region(seeds, 0).size(), 40U * 40U - 16U * 16U) << "the water has its old lattice";
  auto const counts = count_regions(c);
  EXPECT_EQ(counts[0].replaced, 16U * 16U);
  EXPECT_EQ(counts[1].particles, 32U * 32U);
  // A sample of the water is 1/64 m wide: half of one on each side of the charge.
  EXPECT_NEAR(estimated_particles(c), static_cast<double>(seeds.size()), 0.03 * 2400.0);
}

TEST(RegionLattice, StandsOnTheFloorUnderGravity) {
  for (double const g : {-9.81, 9.81}) {
    Case c = charge_in_water(2);
    c.gravity = {0, g, 0};
    auto const charge = of_region(fill_regions(c), 1);
    double const spacing = lattices_of_regions(c)[1].spacing;
    double lowest = 1.0;  // along gravity
    for (Seed const& seed : charge)
      lowest = std::min(lowest, g < 0.0 ? seed.position[1] : -seed.position[1]);
    EXPECT_NEAR(lowest, -0.4 + 0.5 * spacing, 1e-15);
  }
}

TEST(RegionLattice, HydrostaticLayersHaveTheSpacingOfTheirRegion) {
  Case c = charge_in_water(2);
  Tait const tait{.reference_sound_speed = 30.0};
  c.materials[0].eos = tait;
  c.regions.resize(1);
  c.regions[0].shape = Box{{0, 0, 0}, {1, 1, 0}};
  c.regions[0].spacing = 0.1;
  c.regions[0].initial.hydrostatic_level = 1.0;
  c.gravity = {0, -9.81, 0};
  auto const seeds = fill_regions(c);
  ASSERT_EQ(seeds.size(), 100U);
  double face = 0.0;
  for (std::size_t row = 0; row < 10; ++row) {
    Seed const& seed = seeds[10 * row];
    EXPECT_EQ(seed.mass, 1000.0 * std::pow(0.1, 2));
    double const thickness = seed.mass / (seed.density * 0.1);
    EXPECT_NEAR(seed.position[1], face + 0.5 * thickness, 1e-14) << row;
    face += thickness;
  }
}

// Ten metres of clay at 25 cm over rock at 10.3 cm: the face is not between layers of the case.
TEST(RegionLattice, OverburdenSeesTheWeightOfWhatLiesAbove) {
  Case c = charge_in_water(2);
  c.materials = {{"rock", Tait{.reference_density = 2500.0, .reference_sound_speed = 900.0}},
                 {"clay", Tait{.reference_density = 1900.0, .reference_sound_speed = 900.0}}};
  c.gravity = {0, -10.0, 0};
  c.numerics.spacing = 0.25;
  c.regions = {{"rock", "rock", Box{{0, 0, 0}, {2, 3.1, 0}}, {}},
               {"clay", "clay", Box{{0, 3.1, 0}, {2, 13.1, 0}}, {}}};
  c.regions[0].spacing = 0.1;
  for (RegionSpec& region : c.regions) region.initial.lithostatic_load = 0.0;
  c.domain = *default_domain(c);
  for (Seed const& seed : of_region(fill_regions(c), 0)) {
    Tait const& rock = std::get<Tait>(c.materials[0].eos);
    double const weight = 1900.0 * 10.0 * 10.0 + 2500.0 * 10.0 * (3.1 - seed.position[1]);
    // Two faces, each to half of an eighth of a layer of 25 cm; densities up to 2500 kg/m^3.
    EXPECT_NEAR(rock.pressure(seed.density, 0.0), weight, 2.0 * 2500.0 * 10.0 * 0.25 / 16.0);
  }
}

TEST(RegionLattice, FirstRowsOfFineParticlesStandFreeOfTheWallContact) {
  Case c = charge_in_water(2);
  EXPECT_EQ(sweep_parameters(build_model(c)).contact_gap, 0.25 * finest_spacing(c));
  c.regions[1].equal_mass_with.clear();
  c.regions[1].spacing = 0.06;  // coarser than the case: the case's own decides
  EXPECT_EQ(sweep_parameters(build_model(c)).contact_gap, 0.25 * 0.05);
}

TEST(RegionLattice, OneLiquidOfUnequalMassesTakesTheGeneralSweep) {
  Case c = charge_in_water(2);
  c.materials = {{"water", Tait{.reference_sound_speed = 30.0}}};
  for (RegionSpec& region : c.regions) region.material = "water";
  EXPECT_EQ(scheme_of(build_model(c)), SchemeName::liquid) << "equal densities: equal masses";
  c.regions[1].equal_mass_with.clear();
  c.regions[1].spacing = 0.04;
  EXPECT_EQ(scheme_of(build_model(c)), SchemeName::compressible);
}

TEST(RegionLattice, SizeAndItsMessageLookAtTheSpacingOfTheRegion) {
  Case c = charge_in_water(3);
  double const before = estimate_size(c).fluid;
  c.regions[1].equal_mass_with.clear();
  c.regions[1].spacing = 0.01;
  CaseSize const size = estimate_size(c);
  EXPECT_NEAR(size.fluid, before + std::pow(80.0, 3), 0.2 * std::pow(80.0, 3));
  EXPECT_GT(size.bytes, 600.0 * size.particles()) << "lists of 7000 neighbours, not of 58";
  EXPECT_EQ(message_of<InputErrors>([&] { check_size(c, 1e9); }).substr(0, 40),
            "case.toml: region.charge.spacing: makes ");
}

std::string graded(std::string const& more, std::string const& spacing = "0.1") {
  return "space.dimension = 2\nresolution.spacing = " + spacing +
         "\ntime.end = 1\nmaterial = { water = { use = \"water_shock\" }, tnt = { use = \"tnt\" } "
         "}\n"
         "[[region]]\nname = \"sea\"\nmaterial = \"water\"\n"
         "box = { min = [0, 0], max = [8, 8] }\n"
         "[[region]]\nname = \"charge\"\nmaterial = \"tnt\"\n"
         "box = { min = [3, 3], max = [5, 5] }\n" +
         more;
}

std::string mistake(std::string const& more) {
  return message_of<InputErrors>([&] { parse_case(graded(more), "case.toml"); });
}

TEST(RegionLattice, MistakesHaveTheirMessages) {
  EXPECT_EQ(mistake("spacing = 0.05\nequal_mass_with = \"sea\"\n"),
            "case.toml:14:19: region.charge.equal_mass_with: \"sea\" is given together with "
            "spacing; give one of the two");
  EXPECT_EQ(mistake("equal_mass_with = \"see\"\n"),
            "case.toml:13:19: region.charge.equal_mass_with: \"see\" is not a region of this case; "
            "did you mean \"sea\"?");
  EXPECT_EQ(mistake("equal_mass_with = \"charge\"\n"),
            "case.toml:13:19: region.charge.equal_mass_with: \"charge\" leads back to this region; "
            "give one of them a spacing");
  EXPECT_EQ(mistake("equal_mass_with = \"bed\"\n[[region]]\nname = \"bed\"\n"
                    "box = { min = [0, 0], max = [8, 1] }\n"
                    "layers = { materials = [\"tnt\", \"water\"], thickness = [0.5] }\n"),
            "case.toml:13:19: region.charge.equal_mass_with: \"bed\" needs one density in both "
            "regions; \"bed\" has layers; give spacing");
  EXPECT_EQ(mistake("spacing = \"-1 cm\"\n"),
            "case.toml:13:11: region.charge.spacing: \"-1 cm\" must be greater than 0 m");
  EXPECT_EQ(mistake("spacing = 0.2\n"),
            "case.toml:13:11: region.charge.spacing: 0.2 makes the smoothing length of the case, "
            "0.12 m, 0.6 of its spacings; between 0.8 and 8 are possible; at most 0.15 m, or "
            "raise resolution.smoothing_factor");
  EXPECT_EQ(mistake("spacing = 0.01\n"),
            "case.toml:13:11: region.charge.spacing: 0.01 makes the smoothing length of the case, "
            "0.12 m, 12 of its spacings; between 0.8 and 8 are possible; at least 0.015 m, or "
            "refine resolution.spacing");
  EXPECT_EQ(mistake("equal_mass_with = \"sea\"\ndensity = 300\n"),
            "case.toml:13:19: region.charge.equal_mass_with: \"sea\" makes a spacing of 0.1826 m, "
            "and the smoothing length of the case, 0.12 m, 0.657 of its spacings; between 0.8 and "
            "8 are possible; at most 0.15 m, or raise resolution.smoothing_factor");
}

TEST(RegionLattice, MustRepeatItselfInAPeriodicDomainThatItFills) {
  std::string const strip =
      "[[region]]\nname = \"strip\"\nmaterial = \"tnt\"\nspacing = 0.07\n"
      "box = { min = [1, 0], max = [2, 8] }\n"
      "[space]\nperiodic = [\"y\"]\ndomain = { min = [0, 0], max = [8, 8] }\n";
  std::string text = graded(strip);
  text.replace(0, std::string("space.dimension = 2").size(), "");
  text.replace(text.find("periodic"), 0, "dimension = 2\n");
  EXPECT_EQ(message_of<InputErrors>([&] { parse_case(text, "case.toml"); }),
            "case.toml:16:11: region.strip.spacing: 0.07 makes the periodic domain 114.286 "
            "spacings long along y; a whole number is expected");
  text.replace(text.find("0.07"), 4, "0.08");
  EXPECT_EQ(of_region(fill_regions(parse_case(text, "case.toml")), 2).size(), 100U * 13U)
      << "12.5 spacings along x round to 13";
}

TEST(RegionLattice, IsWrittenToTheUsedCaseAndToldOfTheStep) {
  Case const c = parse_case(graded("equal_mass_with = \"sea\"\n"), "case.toml");
  std::string const used = used_case(c);
  EXPECT_NE(used.find("equal_mass_with = \"sea\""), std::string::npos);
  EXPECT_EQ(used_case(parse_case(used, "used.toml")), used);
  EXPECT_NE(explain_step(c).find("h is 1.53 spacings of charge, 0.07833 m"), std::string::npos)
      << explain_step(c);
}

std::string warnings(std::string const& more) {
  std::string text;
  for (auto const& warning : report_case(parse_case(graded(more, "0.2"), "case.toml")).warnings)
    text += format(warning) + '\n';
  return text;
}

TEST(RegionLattice, ChecksWarnOfOddNumbersOfNeighboursAndOfOddBoxes) {
  EXPECT_EQ(warnings("spacing = 0.2\n").find("charge"), std::string::npos);
  EXPECT_NE(
      warnings("spacing = 0.25\n")
          .find("case.toml:13:11: region.charge.spacing: 0.25 makes a spacing of 0.25 m and gives "
                "about 12 neighbours; 21 are usual in 2D: h is 0.96 of these spacings; raise "
                "resolution.smoothing_factor"),
      std::string::npos)
      << warnings("spacing = 0.25\n");
  EXPECT_NE(warnings("spacing = 0.08\n").find("about 1.1e+02 neighbours"), std::string::npos)
      << warnings("spacing = 0.08\n");
  EXPECT_NE(
      warnings("spacing = 0.15\n")
          .find("region.charge.spacing: 0.15 makes the box 13.33 layers long along x; 13 of them "
                "fill it, with 2.5 % less mass; a box of a whole number of layers has its exact "
                "mass"),
      std::string::npos)
      << warnings("spacing = 0.15\n");
}

}  // namespace
}  // namespace moraine
