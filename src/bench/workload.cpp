#include "bench/workload.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "setup/read_case.hpp"

namespace moraine {
namespace {

std::string_view precision_name(Precision precision) {
  return precision == Precision::mixed ? "mixed" : "double";
}

double smoothing_factor(int dimension) { return dimension == 3 ? 1.732 : 1.262; }

/// A length rounded down to whole spacings; the lattice then fills it without a remainder.
double whole(double length, double spacing) {
  return std::floor(length / spacing + 1e-9) * spacing;
}

/// "[x, z]" in 2D, "[x, y, z]" in 3D.
std::string vector(int dimension, double x, double y, double z) {
  return dimension == 3 ? fmt::format("[{}, {}, {}]", x, y, z) : fmt::format("[{}, {}]", x, z);
}

constexpr std::string_view tnt_in_water_text = R"(
title = "TNT charge in a rigid box of water"
space.dimension = 2
resolution = { spacing = "1 cm", smoothing_factor = 2.0, kernel = "wendland_c2" }
numerics = { viscosity_alpha = 1.0, viscosity_beta = 10.0 }
time.end = "500 us"
material.water.eos = "water_polynomial"
material.tnt.eos = "jwl"
[[region]]
name = "water"
material = "water"
box = { min = ["-50 cm", "-50 cm"], max = ["50 cm", "50 cm"] }
[[region]]
name = "charge"
material = "tnt"
box = { min = ["-5 cm", "-5 cm"], max = ["5 cm", "5 cm"] }
[[wall]]
name = "box"
container = { min = ["-50 cm", "-50 cm"], max = ["50 cm", "50 cm"] }
)";

constexpr std::string_view charge_on_soil_text = R"(
title = "6 x 6 cm of TNT on loose sand"
space = { dimension = 2, domain = { min = ["-50 cm", "-1 m"], max = ["50 cm", "1 m"] } }
resolution = { spacing = "1 cm", smoothing_factor = 2.0, kernel = "cubic_spline", smoothing = { mode = "density" } }
numerics = { penalty = { strength = 1e5 } }
time.end = "500 us"
material.sand.use = "sand_loose"
material.tnt.use = "tnt"
[[region]]
name = "ground"
material = "sand"
box = { min = ["-50 cm", "-1 m"], max = ["50 cm", "0 m"] }
[[region]]
name = "charge"
material = "tnt"
box = { min = ["-3 cm", "0 cm"], max = ["3 cm", "6 cm"] }
[[wall]]
name = "box"
container = { min = ["-50 cm", "-1 m"], max = ["50 cm", "1 m"] }
open = ["y+"]
)";

template <int thousandths_of_a_millimetre>
Case dam_break_3d() {
  return dam_break(3, 1e-6 * thousandths_of_a_millimetre, Precision::mixed);
}

Case tnt_in_water_variable() {
  Case c = tnt_in_water();
  c.numerics.smoothing.mode = SmoothingMode::density;
  return c;
}

template <int thousandths_of_a_millimetre>
Case charge_on_soil_3d() {
  return charge_on_soil(1e-6 * thousandths_of_a_millimetre);
}

Workload const list[] = {
    {.name = "dam-break-3d",
     .description = "dam break in 3D, 128 310 particles, mixed precision: the headline number",
     .make = dam_break_3d<8500>,
     .usual = true},
    {.name = "dam-break-3d-double",
     .description = "the same in double precision",
     .make = [] { return dam_break(3, 0.0085, Precision::full); },
     .usual = true},
    {.name = "dam-break-2d",
     .description = "dam break in 2D, 98 736 particles, mixed precision",
     .make = [] { return dam_break(2, 0.0011, Precision::mixed); },
     .usual = true},
    {.name = "tnt-in-water",
     .description = "10 000 particles of water and explosive in 2D, from 0 to 500 microseconds",
     .make = tnt_in_water,
     .warm_up = 0,
     .steps = 0,
     .usual = true},
    {.name = "tnt-in-water-variable",
     .description = "the same with smoothing lengths that follow the density",
     .make = tnt_in_water_variable,
     .warm_up = 0,
     .steps = 0},
    {.name = "charge-on-soil",
     .description = "6 x 6 cm of TNT on 10 000 particles of sand in 2D, h of 2 spacings, from 0 to "
                    "500 microseconds",
     .make = charge_on_soil_2d,
     .warm_up = 0,
     .steps = 0},
    {.name = "charge-on-soil-3d",
     .description = "a quarter of a charge on sand in 3D, 126 000 particles with a strength",
     .make = charge_on_soil_3d<10000>,
     .warm_up = 50,
     .steps = 100},
    {.name = "charge-on-soil-3d-2e6",
     .description = "the same with two million particles",
     .make = charge_on_soil_3d<4000>,
     .warm_up = 10,
     .steps = 20},
    {.name = "dam-break-3d-1e4",
     .description = "scaling with size: 9 900 particles",
     .make = dam_break_3d<20000>},
    {.name = "dam-break-3d-1e5",
     .description = "scaling with size: 99 072 particles",
     .make = dam_break_3d<9300>},
    {.name = "dam-break-3d-1e6",
     .description = "scaling with size: 994 635 particles",
     .make = dam_break_3d<4300>},
    {.name = "dam-break-3d-4e6",
     .description = "scaling with size: 4 074 144 particles",
     .make = dam_break_3d<2700>},
};

}  // namespace

std::span<Workload const> workloads() { return list; }

Workload workload_of_file(std::string_view name) {
  return {.name = name, .description = "of a case file", .make = [name] {
            return read_case(std::string(name));
          }};
}

std::optional<Workload> find_workload(std::string_view name) {
  if (name.ends_with(".toml")) return workload_of_file(name);
  auto const found = std::find_if(std::begin(list), std::end(list),
                                  [&](Workload const& workload) { return workload.name == name; });
  return found == std::end(list) ? std::nullopt : std::optional(*found);
}

Case dam_break(int dimension, double spacing, Precision precision) {
  auto const corner = [&](double x, double y, double z) {
    return vector(dimension, whole(x, spacing), whole(y, spacing), whole(z, spacing));
  };
  // The domain leaves room above and around the tank, so that no splash is lost.
  std::string const text = fmt::format(
      R"(
title = "Dam break"
space.dimension = {dimension}
space.domain = {{ min = {domain_min}, max = {domain_max} }}
physics.gravity = {gravity}
resolution = {{ spacing = {spacing}, smoothing_factor = {factor}, kernel = "wendland_c2" }}
numerics = {{ viscosity_alpha = 0.1, viscosity_beta = 0.0, density_diffusion = 0.1, precision = "{precision}" }}
time.end = "100 s"
material.water = {{ eos = "tait", reference_density = 1000.0, reference_sound_speed = 33.675, exponent = 7.0 }}
[[region]]
name = "column"
material = "water"
box = {{ min = {origin}, max = {column} }}
[[wall]]
name = "tank"
container = {{ min = {origin}, max = {tank} }}
open = ["{top}"]
)",
      fmt::arg("dimension", dimension), fmt::arg("domain_min", vector(dimension, -0.2, -0.2, -0.2)),
      fmt::arg("domain_max", vector(dimension, 1.8, 0.87, 1.6)),
      fmt::arg("gravity", vector(dimension, 0.0, 0.0, -9.81)), fmt::arg("spacing", spacing),
      fmt::arg("factor", smoothing_factor(dimension)),
      fmt::arg("precision", precision_name(precision)),
      fmt::arg("origin", vector(dimension, 0.0, 0.0, 0.0)),
      fmt::arg("column", corner(0.4, 0.67, 0.3)), fmt::arg("tank", corner(1.6, 0.67, 0.4)),
      fmt::arg("top", dimension == 3 ? "z+" : "y+"));
  return parse_case(text, "dam-break");
}

Case tnt_in_water() { return parse_case(tnt_in_water_text, "tnt-in-water"); }

Case charge_on_soil_2d() { return parse_case(charge_on_soil_text, "charge-on-soil"); }

Case charge_on_soil(double spacing) {
  std::string const text = fmt::format(R"(
title = "A quarter of a charge on sand"
space = {{ dimension = 3, symmetry = ["x-", "y-"], domain = {{ min = [0, 0, -0.5], max = [0.5, 0.5, 0.5] }} }}
resolution = {{ spacing = {}, smoothing_factor = 1.3, kernel = "wendland_c2" }}
time.end = "1 ms"
material.sand.use = "sand_loose"
material.tnt.use = "tnt"
[[region]]
name = "ground"
material = "sand"
box = {{ min = [0, 0, -0.5], max = [0.5, 0.5, 0] }}
[[region]]
name = "charge"
material = "tnt"
box = {{ min = [0, 0, 0], max = [0.06, 0.06, 0.06] }}
[[wall]]
name = "box"
container = {{ min = [0, 0, -0.5], max = [0.5, 0.5, 0.5] }}
open = ["x-", "y-", "z+"]
)",
                                       spacing);
  return parse_case(text, "charge-on-soil-3d");
}

Case periodic_block(int dimension, int particles, Precision precision) {
  double const edge = particles;
  std::string const text = fmt::format(
      R"(
title = "Periodic block of water"
space.dimension = {dimension}
space.domain = {{ min = {min}, max = {max} }}
space.periodic = [{periodic}]
resolution = {{ spacing = 1.0, smoothing_factor = {factor}, kernel = "wendland_c2" }}
numerics = {{ viscosity_alpha = 0.1, viscosity_beta = 0.0, density_diffusion = 0.1, precision = "{precision}" }}
time.end = "100 s"
material.water = {{ eos = "tait", reference_sound_speed = 33.675 }}
[[region]]
name = "block"
material = "water"
box = {{ min = {min}, max = {max} }}
)",
      fmt::arg("dimension", dimension), fmt::arg("min", vector(dimension, 0.0, 0.0, 0.0)),
      fmt::arg("max", vector(dimension, edge, edge, edge)),
      fmt::arg("periodic", dimension == 3 ? R"("x", "y", "z")" : R"("x", "y")"),
      fmt::arg("factor", smoothing_factor(dimension)),
      fmt::arg("precision", precision_name(precision)));
  return parse_case(text, "periodic-block");
}

}  // namespace moraine
