#include "setup/case_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

Case basin(int dimension, double spacing) {
  Case c;
  c.file = "case.toml";
  c.dimension = dimension;
  c.numerics.spacing = spacing;
  c.materials = {{"water", WaterPolynomial{}}};
  Box box{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    box.max[axis] = 1.0;
  c.regions = {{"pool", "water", box, {}}};
  WallSpec wall;
  wall.name = "tank";
  wall.box = box;
  c.walls = {wall};
  c.domain = *default_domain(c);
  return c;
}

TEST(CaseSize, AgreesWithWhatIsBuilt) {
  for (int const dimension : {1, 2, 3}) {
    Case c = basin(dimension, dimension == 3 ? 0.05 : 0.01);
    Model const model = build_model(c);
    CaseSize const size = estimate_size(c);
    auto const fluid = static_cast<double>(model.particles.range(Kind::fluid).size());
    auto const walls = static_cast<double>(model.particles.range(Kind::wall).size());
    EXPECT_NEAR(size.fluid, fluid, 1e-9 * fluid);
    // The estimate leaves out the blocks behind edges and corners.
    EXPECT_LE(size.walls, walls * (1.0 + 1e-9));
    EXPECT_GE(size.walls, (dimension == 3 ? 0.6 : 0.9) * walls);
  }
}

TEST(CaseSize, SeesDiscsAndWhatCoversOtherRegions) {
  Case c = basin(2, 0.005);
  c.regions.push_back({"bubble", "water", Disc{{0.5, 0.5, 0.0}, 0.3}, {}});
  c.regions.push_back({"outside", "water", Disc{{3.0, 3.0, 0.0}, 0.3}, {}});
  c.domain = *default_domain(c);
  EXPECT_NEAR(estimated_particles(c), 40000.0, 400.0);  // 1 per cent, as the samples resolve
  c.regions.erase(c.regions.begin());
  double const disc = 3.14159265 * 0.09 / 2.5e-5;
  EXPECT_NEAR(estimated_particles(c), disc, 0.01 * disc);
}

TEST(CaseSize, RefusesWhatDoesNotFit) {
  Case const c = basin(2, 0.01);  // 10 000 fluid and 1200 wall particles, 5.6224 MB
  EXPECT_NO_THROW(check_size(c, 5.7e6));
  try {
    check_size(c, 5.6e6);
    FAIL() << "accepted";
  } catch (InputErrors const& errors) {
    EXPECT_STREQ(errors.what(),
                 "case.toml: resolution.spacing: makes about 1.1e+04 particles, which need about "
                 "0.00562 GB of memory; this machine has 0.0056 GB; a spacing of 0.02 m fits");
  }
}

// Few particles, but filling would ask 1e12 places.
TEST(CaseSize, RefusesRegionsTooFarApart) {
  Case c = basin(2, 0.01);
  c.walls.clear();
  c.regions[0].plus = {{Disc{{9999.9, 9999.9, 0.0}, 0.1}, {}, {}}};
  c.domain = *default_domain(c);
  try {
    check_size(c, 1e9);
    FAIL() << "accepted";
  } catch (InputErrors const& errors) {
    EXPECT_NE(std::string(errors.what()).find("about 1e+12 places for particles"),
              std::string::npos)
        << errors.what();
  }
  c.regions[0].plus = {{Disc{{99.9, 99.9, 0.0}, 0.1}, {}, {}}};
  c.domain = *default_domain(c);
  EXPECT_NO_THROW(check_size(c, 1e9));
}

// At once, with place and value, however fine: filling would take years.
TEST(CaseSize, RefusesWhatCannotBeCounted) {
  try {
    build_model(
        parse_case("[space]\ndimension = 3\n[resolution]\nspacing = \"100 nm\"\n[time]\n"
                   "end = 1\n[material.water]\neos = \"tait\"\n[[region]]\nname = \"pool\"\n"
                   "material = \"water\"\nbox = { min = [0, 0, 0], max = [1, 1, 1] }\n",
                   "case.toml"));
    FAIL() << "accepted";
  } catch (InputErrors const& errors) {
    std::string const text = errors.what();
    EXPECT_EQ(text.find("case.toml:4:11: resolution.spacing: \"100 nm\" makes about 1e+21 "
                        "particles, which need about 6.61e+14 GB of memory; at most 2147483647 "
                        "particles are possible; a spacing of "),
              0U)
        << text;
  }
}

}  // namespace
}  // namespace moraine
