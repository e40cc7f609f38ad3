#include "output/plot/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "output/plot/curve.hpp"
#include "output/plot/stacked_panels.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine::plot {
namespace {

using Labels = std::vector<std::string>;

TEST(LogTicks, AreOneTwoFiveWhereTheyFit) {
  EXPECT_EQ(log_ticks(1.0, 50.0, 7).labels, (Labels{"1", "2", "5", "10", "20", "50"}));
  EXPECT_EQ(log_ticks(0.3, 3.0, 4).labels, (Labels{"0.5", "1", "2"}));
  EXPECT_EQ(log_ticks(35.0, 4000.0, 4).labels, (Labels{"100", "300", "1000", "3000"}));
}

TEST(LogTicks, ArePowersOnLongAxes) {
  EXPECT_EQ(log_ticks(0.5, 2e4, 5).labels, (Labels{"1", "10", "100", "1000", "10000"}));
  EXPECT_EQ(log_ticks(0.5, 2e6, 4).labels, (Labels{"10⁰", "10²", "10⁴", "10⁶"}));
  EXPECT_EQ(log_ticks(1e-9, 1.5e-7, 4).labels,
            (Labels{"10⁻⁹", "3·10⁻⁹", "10⁻⁸", "3·10⁻⁸", "10⁻⁷"}));
}

TEST(LogTicks, AreRoundOnShortAxes) {
  EXPECT_EQ(log_ticks(2.1, 4.9, 4).labels, round_ticks(2.1, 4.9, 4).labels);
  EXPECT_TRUE(log_ticks(0.0, 10.0, 5).values.empty());
  EXPECT_TRUE(log_ticks(-1.0, 10.0, 5).values.empty());
  EXPECT_TRUE(log_ticks(3.0, 3.0, 5).values.empty());
}

// Inside the interval, rising, not too many: for any interval.
TEST(LogTicks, LieInsideAndFit) {
  for (double low = 1e-12; low < 1e12; low *= 7.3)
    for (double ratio = 1.01; ratio < 1e20; ratio *= 3.7)
      for (int const most : {2, 4, 7}) {
        Ticks const ticks = log_ticks(low, low * ratio, most);
        ASSERT_EQ(ticks.values.size(), ticks.labels.size());
        EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most) + 1) << low << " " << ratio;
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
          EXPECT_GE(ticks.values[i], low * (1.0 - 1e-8));
          EXPECT_LE(ticks.values[i], low * ratio * (1.0 + 1e-8));
          if (i > 0) {
            EXPECT_GT(ticks.values[i], ticks.values[i - 1]);
          }
        }
      }
}

TEST(Axis, FractionsOfBothScales) {
  Axis const linear{10.0, 30.0, ""};
  EXPECT_DOUBLE_EQ(linear.fraction(20.0), 0.5);
  Axis const logarithmic{1.0, 1000.0, "", Scale::logarithmic};
  EXPECT_DOUBLE_EQ(logarithmic.fraction(1.0), 0.0);
  EXPECT_DOUBLE_EQ(logarithmic.fraction(1000.0), 1.0);
  EXPECT_DOUBLE_EQ(logarithmic.fraction(10.0), 1.0 / 3.0);
  EXPECT_FALSE(std::isfinite(logarithmic.fraction(0.0)));
  EXPECT_FALSE(std::isfinite(logarithmic.fraction(-5.0)));
}

TEST(Axis, AroundValuesOnALogarithmicScale) {
  Axis const axis = log_axis_around(1.0, 100.0, 0.5, "Pressure (kPa)");
  EXPECT_EQ(axis.scale, Scale::logarithmic);
  EXPECT_DOUBLE_EQ(axis.low, 0.1);
  EXPECT_DOUBLE_EQ(axis.high, 1000.0);
  EXPECT_DOUBLE_EQ(log_axis_around(5.0, 5.0, 0.1, "").low, 0.5);
  EXPECT_DOUBLE_EQ(log_axis_around(0.0, 0.0, 0.1, "").high, 10.0);
}

TEST(Panel, PlacesValuesOnALogarithmicPage) {
  Panel const panel({10.0, 20.0, 300.0, 90.0}, {1.0, 1000.0, "", Scale::logarithmic},
                    {0.1, 100.0, "", Scale::logarithmic});
  EXPECT_DOUBLE_EQ(panel.page_x(10.0), 110.0);
  EXPECT_DOUBLE_EQ(panel.page_x(1000.0), 310.0);
  EXPECT_DOUBLE_EQ(panel.page_y(0.1), 110.0);
  EXPECT_NEAR(panel.page_y(1.0), 80.0, 1e-12);
}

TEST(Labels, BreakWhereTheyAreTooLong) {
  EXPECT_EQ(label_lines("Pressure (kPa)", 128.0), (Labels{"Pressure (kPa)"}));
  EXPECT_EQ(label_lines("Transient horizontal displacement (mm)", 128.0),
            (Labels{"Transient horizontal", "displacement (mm)"}));
  EXPECT_EQ(label_lines("Pressure", 1.0), (Labels{"Pressure"})) << "no blank to break at";
}

// A label in two lines has room for them.
TEST(Panel, GivesRoomToLongLabels) {
  auto const room = [](char const* label) {
    return Panel({0.0, 0.0, 400.0, 128.0}, {}, {0.0, 1.0, label}).y_label_room();
  };
  EXPECT_GT(room("Transient horizontal displacement (mm)"), room("Pressure (kPa)") + 10.0);
}

class LogPlot : public ScratchFolder {};

// A power law is a straight line: all points of the SVG path lie on the diagonal. A value of zero
// leaves a gap.
TEST_F(LogPlot, PowerLawsAreStraight) {
  Panel const panel({0.0, 0.0, 400.0, 400.0}, {1.0, 1e4, "", Scale::logarithmic},
                    {1e-8, 1.0, "", Scale::logarithmic});
  std::vector<double> x, y;
  for (int i = 0; i <= 20; ++i) {
    x.push_back(std::pow(10.0, 0.2 * i));
    y.push_back(1.0 / (x.back() * x.back()));
  }
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(panel.page_y(y[i]), panel.page_x(x[i]), 1e-9);
  y[10] = 0.0;
  Canvas canvas(path("a.svg"), 400.0, 400.0);
  draw_curve(canvas, panel, x, y, {.color = ink, .width = 1.0});
  canvas.finish();
  std::string const svg = bytes_of(path("a.svg"));
  std::string const d = svg.substr(svg.find(" d=\"M") + 4);
  std::string const line = d.substr(0, d.find('"'));
  EXPECT_EQ(std::count(line.begin(), line.end(), 'M'), 2) << line;
}

TEST_F(LogPlot, FaintCurvesShapeNoAxis) {
  std::vector<double> const x{1.0, 10.0, 100.0};
  auto const draw = [&](char const* file, double far) {
    draw_stacked_panels(path(file), "a", {"distance", x}, "m",
                        {{"pressure",
                          "kPa",
                          {{"good", {5.0, 4.0, 3.0}}, {"bad", {far, far, far}, true}},
                          Scale::logarithmic}},
                        Scale::logarithmic);
    return bytes_of(path(file));
  };
  EXPECT_TRUE(draw("a.png", 1e30) == draw("b.png", 1e25)) << "both are far outside the panel";
  EXPECT_FALSE(draw("c.png", 4.5) == draw("d.png", 1e25));
}

TEST_F(LogPlot, WordsHaveRoomBelowThePanel) {
  auto const room = [](std::vector<std::string> const& words) {
    return Panel({0.0, 0.0, 100.0, 100.0}, {-0.5, 1.5, "kernel", Scale::linear, words}, {})
        .x_label_room();
  };
  EXPECT_GT(room({"a", "a word of some length"}), room({"a", "b"}) + 50.0);
  auto const draw = [&](char const* file, std::vector<std::string> const& words) {
    Canvas canvas(path(file), 200.0, 200.0);
    Panel const panel({50.0, 10.0, 100.0, 100.0}, {-0.5, 1.5, "kernel", Scale::linear, words}, {});
    panel.draw_axes(canvas, {}, 40.0);
    canvas.finish();
    return bytes_of(path(file));
  };
  EXPECT_FALSE(draw("a.png", {"lucy", "dome"}) == draw("b.png", {"lucy", "done"}));
}

}  // namespace
}  // namespace moraine::plot
