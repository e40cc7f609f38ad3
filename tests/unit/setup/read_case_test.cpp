#include "setup/read_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <variant>

#include "setup/parameter_table.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

// Every kind of table, every law, every shape, both forms of wall, both kinds of gauge.
constexpr std::string_view full_text = R"(title = "a \"full\" case: \\ µ"
[space]
dimension = 2
domain = { min = ["-1 m", -2], max = [3, 3.3] }
periodic = ["x"]
[physics]
gravity = ["1 cm/s^2", "-1 g0"]
[resolution]
spacing = "1 cm"
smoothing_factor = 1.7
kernel = "cubic_spline"
[numerics]
precision = "double"
density_diffusion = 0.1
viscosity_alpha = 0.5
viscosity_beta = 2
[time]
end = "0.3 ms"
courant = 0.2
max_step = "3 us"
fixed_step = 1e-6
[output]
frames = "7 us"
frame_times = ["1 us", 3e-6]
gauges = "11 ns"
sums = 1e-5
[material.zinc-blue]
eos = "tait"
reference_sound_speed = "30 m/s"
reference_density = "1.1 g/cm^3"
exponent = 7.15
background_pressure = "1 kPa"
reference_energy = 5
[material.water]
eos = "water_polynomial"
cavitation_pressure = "-1 MPa"
[material.tnt]
eos = "jwl"
b = "3.21 GPa"
[material."the air"]
eos = "ideal_gas"
heat_capacity_ratio = 1.41
[[region]]
name = "half"
material = "zinc-blue"
half_plane = { point = [0, 0.1], normal = [3, 4] }
hydrostatic_level = "20 cm"
[[region]]
name = "box"
material = "water"
box = { min = [0.1, 0.1], max = [0.9, 0.7] }
velocity = [1, "-2 km/s"]
density = 1001.5
specific_energy = "0.3 kJ/kg"
[[region]]
name = "ball"
material = "the air"
disc = { center = [0.5, 0.3], radius = "7 mm" }
pressure = "1 atm"
[[wall]]
name = "tank"
container = { min = [-0.5, 0], max = [1, 1] }
open = ["y+", "x-"]
slip = "none"
[[wall]]
name = "step"
solid = { min = [0.6, 0], max = [0.7, 0.1] }
[[gauge]]
name = "a"
position = [0.2, 0.3]
[[gauge]]
name = "b"
kind = "front"
material = "tnt"
axis = "y-"
)";

TEST(ReadCase, PutsEveryValueInItsPlace) {
  Case const c = parse_case(full_text, "full.toml");
  EXPECT_EQ(c.title, "a \"full\" case: \\ \u00b5");
  EXPECT_EQ(c.file, "full.toml");
  EXPECT_EQ(c.dimension, 2);
  EXPECT_EQ(c.domain.min, (Point{-1, -2, 0}));
  EXPECT_EQ(c.domain.max, (Point{3, 3.3, 0}));
  EXPECT_EQ(c.periodic, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(c.gravity, (Point{0.01, -9.80665, 0}));
  EXPECT_EQ(c.numerics.spacing, 0.01);
  EXPECT_EQ(c.numerics.smoothing_factor, 1.7);
  EXPECT_EQ(c.numerics.kernel, KernelName::cubic_spline);
  EXPECT_EQ(c.numerics.precision, Precision::full);
  EXPECT_EQ(c.numerics.density_diffusion, 0.1);
  EXPECT_EQ(c.numerics.viscosity_alpha, 0.5);
  EXPECT_EQ(c.numerics.viscosity_beta, 2.0);
  EXPECT_EQ(c.time.end, 0.3e-3);
  EXPECT_EQ(c.time.courant, 0.2);
  EXPECT_EQ(c.time.max_step, 3e-6);
  EXPECT_EQ(c.time.fixed_step, 1e-6);
  EXPECT_EQ(c.output.frame_interval, 7e-6);
  EXPECT_EQ(c.output.frame_times, (std::vector<double>{1e-6, 3e-6}));
  EXPECT_EQ(c.output.gauge_interval, 11e-9);
  EXPECT_EQ(c.output.sums_interval, 1e-5);
}

TEST(ReadCase, PutsEveryObjectInItsPlace) {
  Case const c = parse_case(full_text, "full.toml");
  ASSERT_EQ(c.materials.size(), 4U);  // in the order of the file
  EXPECT_EQ(c.materials[0].name, "zinc-blue");
  auto const& tait = std::get<Tait>(c.materials[0].eos);
  EXPECT_EQ(tait.reference_density, 1100.0);
  EXPECT_EQ(tait.reference_sound_speed, 30.0);
  EXPECT_EQ(tait.background_pressure, 1000.0);
  EXPECT_EQ(std::get<WaterPolynomial>(c.materials[1].eos).cavitation_pressure, -1e6);
  EXPECT_EQ(std::get<Jwl>(c.materials[2].eos).b, 3.21e9);
  EXPECT_EQ(std::get<IdealGas>(c.materials[3].eos).heat_capacity_ratio, 1.41);

  ASSERT_EQ(c.regions.size(), 3U);
  auto const& plane = std::get<HalfPlane>(c.regions[0].shape);
  EXPECT_DOUBLE_EQ(plane.normal[0], 0.6);
  EXPECT_DOUBLE_EQ(plane.normal[1], 0.8);
  EXPECT_EQ(c.regions[0].initial.hydrostatic_level, 0.2);
  EXPECT_EQ(c.regions[0].initial.density, std::nullopt);
  EXPECT_EQ(std::get<Box>(c.regions[1].shape).max, (Point{0.9, 0.7, 0}));
  EXPECT_EQ(c.regions[1].initial.velocity, (Point{1, -2000, 0}));
  EXPECT_EQ(c.regions[1].initial.density, 1001.5);
  EXPECT_EQ(c.regions[1].initial.specific_energy, 300.0);
  EXPECT_EQ(std::get<Disc>(c.regions[2].shape).radius, 0.007);
  EXPECT_EQ(c.regions[2].initial.pressure, 101325.0);

  ASSERT_EQ(c.walls.size(), 2U);
  EXPECT_EQ(c.walls[0].form, WallForm::container);
  EXPECT_TRUE(c.walls[0].open[0][0]);
  EXPECT_FALSE(c.walls[0].open[0][1]);
  EXPECT_FALSE(c.walls[0].open[1][0]);
  EXPECT_TRUE(c.walls[0].open[1][1]);
  EXPECT_EQ(c.walls[0].slip, Slip::none);
  EXPECT_EQ(c.walls[1].form, WallForm::solid);
  EXPECT_EQ(c.walls[1].box.min, (Point{0.6, 0, 0}));
  EXPECT_EQ(c.walls[1].slip, Slip::free);

  ASSERT_EQ(c.gauges.size(), 2U);
  EXPECT_EQ(c.gauges[0].kind, GaugeKind::point);
  EXPECT_EQ(c.gauges[0].position, (Point{0.2, 0.3, 0}));
  EXPECT_EQ(c.gauges[1].kind, GaugeKind::front);
  EXPECT_EQ(c.gauges[1].material, "tnt");
  EXPECT_EQ(c.gauges[1].axis, 1);
  EXPECT_EQ(c.gauges[1].direction, -1);
}

// The used case lists every value of a Case, so equal texts mean equal cases.
TEST(UsedCase, ReadsBackToTheSameCase) {
  std::string const once = used_case(parse_case(full_text, "full.toml"));
  Case const again = parse_case(once, "used.toml");
  EXPECT_EQ(used_case(again), once);
  EXPECT_EQ(std::get<HalfPlane>(again.regions[0].shape).normal,
            std::get<HalfPlane>(parse_case(full_text, "").regions[0].shape).normal);
}

constexpr std::string_view small_text = R"(space.dimension = 3
resolution.spacing = 0.1
time.end = 1
[material.a]
eos = "ideal_gas"
[[region]]
name = "r"
material = "a"
box = { min = [0, 0, 0], max = [1, 2, 3] }
)";

TEST(UsedCase, FillsInDefaults) {
  Case const c = parse_case(small_text, "small.toml");
  std::string const text = used_case(c);
  EXPECT_EQ(used_case(parse_case(text, "used.toml")), text);
  for (auto const line :
       {"max_step = inf  # s\n", "smoothing_factor = 1.2\n", "heat_capacity_ratio = 1.4\n",
        "velocity = [0.0, 0.0, 0.0]  # m/s\n", "domain.min = [-1.0, -2.0, -3.0]  # m\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
}

TEST(ReadCase, DefaultsOfTheTableAreThoseOfTheStructs) {
  Case const c = parse_case(small_text, "small.toml");
  Case const plain;
  for (auto const& [parameter, set, get] : case_entries()) {
    if (parameter.presence == Presence::optional) {
      EXPECT_EQ(get(c), get(plain)) << parameter.key;
    }
  }
  EXPECT_EQ(std::get<IdealGas>(c.materials[0].eos).reference_density, IdealGas{}.reference_density);
}

TEST(ReadCase, DefaultDomainGrowsWherePeriodicityDoesNotForbidIt) {
  std::string const text = std::string("space.periodic = [\"y\"]\n") + std::string(small_text) +
                           "[[wall]]\nname = \"w\"\ncontainer = { min = [0, 0, -1], max = [1, 2, "
                           "1] }\n";
  Case const c = parse_case(text, "small.toml");
  EXPECT_EQ(c.domain.min, (Point{-1, 0, -5}));
  EXPECT_EQ(c.domain.max, (Point{2, 2, 7}));
}

TEST(ParameterTable, IsCompleteAsData) {
  std::set<std::string> keys;
  for (auto const* parameter : all_parameters()) {
    std::string const key = full_key(*parameter) + ' ' + std::string(parameter->when_value);
    EXPECT_TRUE(keys.insert(key).second) << key << " is listed twice";
    EXPECT_FALSE(parameter->meaning.empty()) << key;
    bool const named =
        parameter->type == ValueType::choice || parameter->type == ValueType::shape_key;
    if (parameter->type != ValueType::texts) {
      EXPECT_EQ(parameter->names.empty(), !named) << key;
    }
    bool const has_default = !std::holds_alternative<std::monostate>(parameter->preset);
    if (parameter->presence == Presence::required) {
      EXPECT_FALSE(has_default) << key;
    }
    EXPECT_LT(parameter->limits.min, parameter->limits.max) << key;
  }
  EXPECT_TRUE(keys.contains("time.end "));
  EXPECT_TRUE(keys.contains("material.NAME.omega jwl"));
  EXPECT_TRUE(keys.contains("region[].box.min box"));
}

TEST(ParameterTable, NamesOfLawsFollowTheVariant) {
  auto const& eos = material_entries()[1];  // behind the other way to choose a law, `use`
  ASSERT_EQ(eos.parameter.key, "eos");
  ASSERT_EQ(eos.parameter.names.size(), std::variant_size_v<Eos>);
  for (std::size_t i = 0; i < eos.parameter.names.size(); ++i) {
    MaterialSpec material;
    eos.set(material, static_cast<int>(i));
    EXPECT_EQ(eos_name(material.eos), eos.parameter.names[i]);
  }
}

}  // namespace
}  // namespace moraine
