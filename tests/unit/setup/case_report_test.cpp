// `moraine check`: numbers of the report, and one case for every doubt.
#include "setup/case_report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "setup/case_size.hpp"
#include "setup/case_warnings.hpp"
#include "setup/read_case.hpp"
#include "setup/smoothing_warnings.hpp"
#include "smoothing/any_kernel.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

// A tank of 1 m x 0.5 m without doubts: 50 x 25 particles of h = 3 cm.
constexpr std::string_view good_text = R"(title = "test"
[space]
dimension = 2
[physics]
gravity = [0, -9.81]
[resolution]
spacing = "2 cm"
smoothing_factor = 1.5
[time]
end = "1 s"
[material.water]
use = "water"
reference_sound_speed = "40 m/s"
[[region]]
name = "pool"
material = "water"
box = { min = [0, 0], max = [1, 0.5] }
[[wall]]
name = "tank"
container = { min = [0, 0], max = [1, 0.8] }
[[gauge]]
name = "probe"
position = [0.5, 0.3]
[output]
frames = "0.1 s"
)";

CaseReport report_of(std::string_view from, std::string_view to) {
  std::string text(good_text);
  auto const place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return report_case(parse_case(text.replace(place, from.size(), to), "case.toml"));
}

std::string warnings_of(std::string_view from, std::string_view to) {
  std::string text;
  for (auto const& warning : report_of(from, to).warnings) text += format(warning) + '\n';
  return text;
}

TEST(CaseReport, CountsAndEstimates) {
  Case const c = parse_case(good_text, "case.toml");
  CaseReport const report = report_case(c);
  ASSERT_EQ(report.fluid.size(), 1u);
  EXPECT_EQ(report.fluid[0].material, "water");
  EXPECT_EQ(report.fluid[0].particles, 50u * 25u);
  EXPECT_EQ(report.bytes, estimate_size(c).bytes);
  // 0.3 h / (c (1 + 0.6 alpha)): fluid at rest, at the reference density.
  EXPECT_NEAR(report.time_step, 0.3 * 0.03 / (40.0 * 1.6), 1e-12);
  EXPECT_EQ(report.limited_by, "sound and viscosity");
  EXPECT_EQ(report.steps, 7112.0);  // 1 s / 140.625 us, rounded up
  EXPECT_GE(report.timed_steps, 2);
  EXPECT_GT(report.wall_time(), 0.0);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(CaseWarnings, GaugeAwayFromTheFluid) {
  EXPECT_EQ(warnings_of("[0.5, 0.3]", "[0.51, 0.7]"),
            "case.toml:23:12: gauge.probe.position: [0.51, 0.7] starts 0.21 m from the nearest "
            "particle and reads nothing before fluid comes within the kernel support, 0.06 m\n");
}

TEST(CaseWarnings, FrontOfAnAbsentMaterial) {
  EXPECT_EQ(warnings_of("position = [0.5, 0.3]",
                        "kind = \"front\"\nmaterial = \"air\"\n[material.air]\nuse = \"air\""),
            "case.toml:24:12: gauge.probe.material: \"air\" is the material of no particle\n");
}

TEST(CaseWarnings, ThinRegion) {
  EXPECT_EQ(warnings_of("[[wall]]",
                        "[[region]]\nname = \"film\"\nmaterial = \"water\"\n"
                        "box = { min = [0, 0.5], max = [1, 0.54] }\n[[wall]]"),
            "case.toml:18:1: region.film: is 0.04 m thin along y, 2 spacings; the kernel reaches "
            "0.06 m (2 h), across all of it; refine the spacing or make it thicker\n");
}

TEST(CaseWarnings, ThinWall) {
  EXPECT_EQ(warnings_of("[[gauge]]",
                        "[[wall]]\nname = \"plate\"\n"
                        "solid = { min = [0.2, 0.1], max = [0.24, 0.4] }\n[[gauge]]"),
            "case.toml:21:1: wall.plate: is 0.04 m thin along x, 2 spacings; the kernel reaches "
            "0.06 m (2 h), across all of it; refine the spacing or make it thicker\n");
}

// sqrt(2 * 9.81 * 0.5) = 3.13 m/s.
TEST(CaseWarnings, SoundSpeedAgainstTheFall) {
  EXPECT_EQ(warnings_of("40 m/s", "20 m/s"),
            "case.toml:13:25: material.water.reference_sound_speed: \"20 m/s\" is 6.39 "
            "times the speed to expect, 3.13 m/s; with less than ten times the density varies by "
            "more than 1 %\n");
  EXPECT_EQ(warnings_of("40 m/s", "1480 m/s"),
            "case.toml:13:25: material.water.reference_sound_speed: \"1480 m/s\" is "
            "473 times the speed to expect, 3.13 m/s; ten times would take 47.3 times fewer "
            "steps\n");
}

TEST(CaseWarnings, SoundSpeedAgainstTheStart) {
  EXPECT_EQ(warnings_of("material = \"water\"", "material = \"water\"\nvelocity = [8, 6]"),
            "case.toml:13:25: material.water.reference_sound_speed: \"40 m/s\" is 4 "
            "times the speed to expect, 10 m/s; with less than ten times the density varies by "
            "more than 1 %\n");
  // sqrt(2 * 50 kPa / 1000 kg/m^3) = 10 m/s.
  EXPECT_EQ(warnings_of("material = \"water\"", "material = \"water\"\npressure = \"50 kPa\""),
            "case.toml:13:25: material.water.reference_sound_speed: \"40 m/s\" is 4 "
            "times the speed to expect, 10 m/s; with less than ten times the density varies by "
            "more than 1 %\n");
}

TEST(CaseWarnings, SmoothingFactorAgainstTheKernel) {
  EXPECT_EQ(warnings_of("smoothing_factor = 1.5", "smoothing_factor = 0.9"),
            "case.toml:8:20: resolution.smoothing_factor: 0.9 gives about 10 neighbours; "
            "21 are usual in 2D\n");
  EXPECT_EQ(
      warnings_of("smoothing_factor = 1.5", "smoothing_factor = 1.6\nkernel = \"cubic_spline\""),
      "case.toml:8:20: resolution.smoothing_factor: 1.6 puts neighbours at rest inside the "
      "inflection point of the cubic spline, where they may form pairs; at most 1.5, or the "
      "kernel wendland_c2\n");
  EXPECT_EQ(
      warnings_of("smoothing_factor = 1.5", "smoothing_factor = 1.5\nkernel = \"cubic_spline\""),
      "");
}

TEST(CaseWarnings, KernelsThatPairOrPull) {
  auto const with = [](std::string const& factor, std::string const& kernel) {
    return warnings_of("smoothing_factor = 1.5",
                       "smoothing_factor = " + factor + "\nkernel = \"" + kernel + "\"");
  };
  EXPECT_EQ(with("1.8", "quartic_spline"), "");
  EXPECT_EQ(with("1.85", "quartic_spline"),
            "case.toml:8:20: resolution.smoothing_factor: 1.85 puts neighbours at rest inside the "
            "inflection point of the quartic spline, where they may form pairs; at most 1.81, or "
            "the kernel wendland_c2\n");
  EXPECT_EQ(with("1.5", "super_gaussian"),
            "case.toml:9:10: resolution.kernel: \"super_gaussian\" rises again far outside, where "
            "pressure pulls and viscosity cools; for comparison only; take wendland_c2\n");
  EXPECT_EQ(with("1.5", "dome"),
            "case.toml:9:10: resolution.kernel: \"dome\" lets the force jump where a neighbour "
            "comes or goes: the energy suffers; for comparison only, with time.courant = 0.15\n");
  // The slope is steepest where the warnings say: nearest neighbours at 1/q spacings.
  for (auto const& [kernel, factor] :
       {std::pair{KernelName::lucy, 1.5}, std::pair{KernelName::liu_quartic, 1.586},
        std::pair{KernelName::quartic_spline, 1.809}, std::pair{KernelName::quintic_spline, 1.976},
        std::pair{KernelName::gaussian, 2.1213}}) {
    AnyKernel<2> const formula(kernel);
    auto const slope = [&](double q) { return q * formula.slope_over_q(q); };
    double const q = 1.0 / factor;
    EXPECT_LT(slope(q), slope(0.97 * q)) << kernel_name(kernel);
    EXPECT_LT(slope(q), slope(1.03 * q)) << kernel_name(kernel);
  }
}

/// What is said of h while products of an explosive expand.
std::string doubts_of_products(Case const& c) {
  std::vector<InputProblem> warnings;
  add_smoothing_warnings(c, warnings);
  std::string text;
  for (auto const& warning : warnings)
    if (warning.rule.find("expands") != std::string::npos) text += format(warning) + '\n';
  return text;
}

TEST(CaseWarnings, ProductsThatLoseTheirNeighbours) {
  auto const with = [](std::string const& resolution, std::string const& charge) {
    return doubts_of_products(parse_case(
        "space.dimension = 2\ntime.end = 1\n[resolution]\nspacing = 0.02\n" + resolution +
            "\n[material.charge]\nuse = \"tnt\"\n[[region]]\nname = \"block\"\n" + charge +
            "\nmaterial = \"charge\"\nbox = { min = [0, 0], max = [1, 1] }\n",
        "case.toml"));
  };
  std::string const doubt =
      " spacings of charge while it expands, and its particles lose their neighbours; give "
      "smoothing = { mode = \"density\" }, or 2 spacings\n";
  EXPECT_EQ(with("smoothing_factor = 1.5", ""),
            "case.toml:5:20: resolution.smoothing_factor: 1.5 keeps h at 1.5" + doubt);
  EXPECT_EQ(with("", ""), "case.toml: resolution.smoothing_factor: 1.2 keeps h at 1.2" + doubt);
  EXPECT_EQ(with("smoothing_factor = 2", ""), "");
  EXPECT_EQ(with("smoothing = { mode = \"density\" }", ""), "");
  EXPECT_EQ(with("", "spacing = 0.01"), "") << "2.4 of its own spacings";
  EXPECT_EQ(with("smoothing_factor = 2", "spacing = 0.025"),
            "case.toml:5:20: resolution.smoothing_factor: 2 keeps h at 1.6" + doubt);
}

TEST(CaseWarnings, ShippedProductsKeepTheirNeighbours) {
  for (EmbeddedText const& shipped : shipped_cases())
    EXPECT_EQ(doubts_of_products(shipped_case(shipped.name)), "") << shipped.name;
}

TEST(CaseWarnings, OutputAgainstTheEnd) {
  EXPECT_EQ(warnings_of("frames = \"0.1 s\"", "frames = \"2 s\""),
            "case.toml:25:10: output.frames: \"2 s\" is longer than the run, which ends at 1 s\n");
  EXPECT_EQ(warnings_of("frames = \"0.1 s\"", "frames = \"10 us\""),
            "case.toml:25:10: output.frames: \"10 us\" is shorter than the first time step, "
            "0.000141 s: every step is written\n"
            "case.toml:25:10: output.frames: \"10 us\" makes 100000 frames until 1 s\n");
  EXPECT_EQ(warnings_of("frames = \"0.1 s\"", "frame_times = [0.5, 3]"),
            "case.toml:25:15: output.frame_times: [0.5, 3] asks for a frame at 3 s, after the end "
            "of the run, 1 s\n");
}

TEST(CaseReport, AStartThatNoLawAnswersIsAMistake) {
  EXPECT_THROW(report_of("use = \"water\"\nreference_sound_speed = \"40 m/s\"",
                         "use = \"air\"\nreference_energy = \"1e-320 J/kg\""),
               InputErrors);
}

}  // namespace
}  // namespace moraine
