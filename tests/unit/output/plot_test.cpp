#include "output/plot/plot.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "output/plot/color_bar.hpp"
#include "output/plot/color_map.hpp"
#include "output/plot/curve.hpp"
#include "output/plot/frame_field.hpp"
#include "output/pvd_collection.hpp"
#include "output/table_csv.hpp"
#include "output/vtp_writer.hpp"
#include "scratch_folder.hpp"

namespace moraine {
namespace {

using PlotTest = ScratchFolder;

/// nx by ny particles 1 cm apart (ny = 1 for 1D); pressure 0 in the left half, 1 MPa in the right.
ParticleStore halves(int dimension, int nx, int ny) {
  ParticleStore store(dimension);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      std::size_t const p = store.append(Kind::fluid, 0);
      store.component(Field::position, 0)[p] = (i + 0.5) * 0.01;
      if (dimension > 1) store.component(Field::position, dimension - 1)[p] = (j + 0.5) * 0.01;
      store.component(Field::velocity, 0)[p] = 3.0;
      if (dimension > 1) store.component(Field::velocity, 1)[p] = -4.0;
      store.scalar(Field::pressure)[p] = 2 * i < nx ? 0.0 : 1e6;
      store.scalar(Field::density)[p] = 1000.0;
      store.scalar(Field::mass)[p] = 1000.0 * std::pow(0.01, dimension);
    }
  return store;
}

struct Picture {
  explicit Picture(std::filesystem::path const& file)
      : surface(cairo_image_surface_create_from_png(file.c_str())) {}
  ~Picture() { cairo_surface_destroy(surface); }
  Picture(Picture const&) = delete;
  Picture& operator=(Picture const&) = delete;

  /// Number of pixels within two levels of a colour.
  int count(plot::Color const& color) const {
    int const width = cairo_image_surface_get_width(surface);
    int const height = cairo_image_surface_get_height(surface);
    unsigned char const* const data = cairo_image_surface_get_data(surface);
    int found = 0;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        unsigned char const* const pixel =
            data + row * cairo_image_surface_get_stride(surface) + 4 * column;
        auto const near = [](unsigned char byte, double part) {
          return std::abs(byte - part * 255.0) <= 2.0;
        };
        if (near(pixel[0], color.blue) && near(pixel[1], color.green) && near(pixel[2], color.red))
          ++found;
      }
    return found;
  }

  cairo_surface_t* surface;
};

TEST(RoundTicks, AreRoundAndInside) {
  auto const ticks = plot::round_ticks(-0.03, 1.04, 5);
  EXPECT_EQ(ticks.labels, (std::vector<std::string>{"0.00", "0.25", "0.50", "0.75", "1.00"}));
  EXPECT_EQ(plot::round_ticks(-20.0, 20.0, 4).labels,
            (std::vector<std::string>{"−20", "−10", "0", "10", "20"}));
  EXPECT_EQ(plot::round_ticks(0.0, 2e-4, 2).labels,
            (std::vector<std::string>{"0.0000", "0.0001", "0.0002"}));
  EXPECT_TRUE(plot::round_ticks(1.0, 1.0, 5).values.empty());
}

TEST(AxisAround, IncludesNearZeroAndWidensAnEmptyInterval) {
  EXPECT_EQ(plot::axis_around(1.0, 10.0, 0.05, "").low, 0.0);
  EXPECT_DOUBLE_EQ(plot::axis_around(1000.0, 1010.0, 0.1, "").low, 999.0);
  EXPECT_LT(plot::axis_around(5.0, 5.0, 0.1, "").low, 5.0);
  EXPECT_EQ(plot::rounded_out({0.001, 1.999, ""}).high, 2.0);
  EXPECT_EQ(plot::rounded_out({0.001, 1.9, ""}).high, 1.9);
}

// Entries 8, 136, 232 and 248 of the 256-entry table, half-way between interpolation points.
TEST(Viridis, FollowsThePublishedTable) {
  struct Entry {
    int index;
    plot::Color color;
  };
  for (auto const& [index, expected] :
       {Entry{0, {0.267004, 0.004874, 0.329415}}, Entry{8, {0.277018, 0.050344, 0.375715}},
        Entry{136, {0.120565, 0.596422, 0.543611}}, Entry{232, {0.762373, 0.876424, 0.137064}},
        Entry{248, {0.926106, 0.897330, 0.104071}}, Entry{255, {0.993248, 0.906157, 0.143936}}}) {
    plot::Color const color = plot::viridis(index / 255.0);
    EXPECT_NEAR(color.red, expected.red, 0.025) << index;
    EXPECT_NEAR(color.green, expected.green, 0.025) << index;
    EXPECT_NEAR(color.blue, expected.blue, 0.025) << index;
  }
}

TEST(ColorRange, CutsOffFewExtremeValues) {
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i) values.push_back(i);
  auto const whole = plot::color_range(values);
  EXPECT_EQ(whole.low, 0.0);
  EXPECT_EQ(whole.high, 9999.0);
  EXPECT_FALSE(whole.above);
  values[5] = 1e9;
  values[6] = std::nan("");
  auto const cut = plot::color_range(values);
  EXPECT_LT(cut.high, 10000.0);
  EXPECT_TRUE(cut.above);
  auto const flat = plot::color_range({7.0, 7.0});
  EXPECT_LT(flat.low, 7.0);
  EXPECT_GT(flat.high, 7.0);
}

TEST_F(PlotTest, FieldIsMagnitudeOrComponent) {
  write_vtp(path("a.vtp"), halves(2, 4, 2), Kind::fluid, 0.0);
  ParticleFrame const frame = read_vtp(path("a.vtp"));
  EXPECT_DOUBLE_EQ(plot::frame_field(frame, "velocity").values[0], 5.0);
  EXPECT_DOUBLE_EQ(plot::frame_field(frame, "velocity_y").values[0], -4.0);
  // Float32 in the file: relative 6e-8, halved by the root.
  EXPECT_NEAR(plot::spacings(frame)[0], 0.01, 1e-9);
  std::string const message =
      message_of<std::invalid_argument>([&] { plot::frame_field(frame, "presure"); });
  EXPECT_NE(message.find("no field 'presure'"), std::string::npos);
  EXPECT_NE(message.find("velocity, velocity_x"), std::string::npos) << message;
  EXPECT_NE(message.find("pressure"), std::string::npos) << message;
}

/// Dots touch: each half of the plot shows the colour of its pressure nearly everywhere.
void expect_two_halves(std::filesystem::path const& png) {
  Picture const picture(png);
  double const area = std::pow(plot::pixels_per_point, 2) * 400.0 * 200.0;  // 2:1 view, 400 pt wide
  EXPECT_GT(picture.count(plot::viridis(0.0)), 0.45 * area);
  EXPECT_GT(picture.count(plot::viridis(1.0)), 0.45 * area);
  EXPECT_LT(picture.count(plot::viridis(0.5)), 0.01 * area);
}

TEST_F(PlotTest, FrameShowsTheValueOfEachParticle) {
  write_vtp(path("a.vtp"), halves(2, 60, 30), Kind::fluid, 0.0);
  plot_frame(path("a.vtp"), "pressure", path("a.png"));
  expect_two_halves(path("a.png"));
}

// A view ten times as high as wide has empty sides: both axes keep one scale.
TEST_F(PlotTest, TallFramesKeepTheirShape) {
  write_vtp(path("a.vtp"), halves(2, 10, 100), Kind::fluid, 0.0);
  plot_frame(path("a.vtp"), "pressure", path("a.png"));
  double const scale = plot::pixels_per_point * 440.0 / 1.03;  // a metre and its margins, in pixels
  double const half = 0.05 * scale * 1.0 * scale;
  EXPECT_NEAR(Picture(path("a.png")).count(plot::viridis(0.0)), half, 0.1 * half);
  EXPECT_NEAR(Picture(path("a.png")).count(plot::viridis(1.0)), half, 0.1 * half);
}

TEST_F(PlotTest, FrameIn3dIsLookedAtFromTheSide) {
  ParticleStore store = halves(3, 60, 30);
  write_vtp(path("a.vtp"), store, Kind::fluid, 0.0);
  plot_frame(path("a.vtp"), "pressure", path("a.png"));
  expect_two_halves(path("a.png"));
  // A sheet behind must not be seen; in front it hides the rest.
  for (double const y : {1.0, -1.0}) {
    ParticleStore sheets = halves(3, 60, 30);
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 60; ++i) {
        std::size_t const p = sheets.append(Kind::fluid, 0);
        sheets.component(Field::position, 0)[p] = (i + 0.5) * 0.01;
        sheets.component(Field::position, 1)[p] = y;
        sheets.component(Field::position, 2)[p] = (j + 0.5) * 0.01;
        sheets.scalar(Field::pressure)[p] = 5e5;
        sheets.scalar(Field::density)[p] = 1000.0;
        sheets.scalar(Field::mass)[p] = 1e-3;
      }
    write_vtp(path("b.vtp"), sheets, Kind::fluid, 0.0);
    plot_frame(path("b.vtp"), "pressure", path("b.png"));
    plot::Color const shown = plot::viridis(std::round(0.5 * 255.0) / 255.0);
    int const pixels = Picture(path("b.png")).count(shown);
    if (y > 0.0)
      EXPECT_LT(pixels, 10000);
    else
      EXPECT_GT(pixels, 400000);
  }
}

TEST_F(PlotTest, ManyParticlesBecomeAPictureInSvg) {
  write_vtp(path("few.vtp"), halves(2, 20, 10), Kind::fluid, 0.0);
  write_vtp(path("many.vtp"), halves(2, 210, 100), Kind::fluid, 0.0);
  plot_frame(path("few.vtp"), "pressure", path("few.svg"));
  plot_frame(path("many.vtp"), "pressure", path("many.svg"));
  EXPECT_EQ(bytes_of(path("few.svg")).find("<image"), std::string::npos);
  EXPECT_NE(bytes_of(path("many.svg")).find("<image"), std::string::npos);
  EXPECT_LT(std::filesystem::file_size(path("many.svg")), 1000000U);
}

TEST_F(PlotTest, CurveKeepsPeaksWhenThinned) {
  std::vector<double> x, y;
  for (int i = 0; i < 50000; ++i) {
    x.push_back(i);
    y.push_back(0.0);
  }
  plot::Panel const panel({0.0, 0.0, 400.0, 90.0}, {0.0, 50000.0, ""}, {-1.0, 2.0, ""});
  auto const draw = [&](char const* file) {
    plot::Canvas canvas(path(file), 400.0, 90.0);
    plot::draw_curve(canvas, panel, x, y, {.color = plot::line_color(0), .width = 1.2});
    canvas.finish();
  };
  draw("flat.png");
  y[20123] = 1.0;
  draw("spike.png");
  draw("spike.svg");
  int const added = Picture(path("spike.png")).count(plot::line_color(0)) -
                    Picture(path("flat.png")).count(plot::line_color(0));
  // The spike is 30 pt high and 1.2 pt wide; smoothing takes up to half of its three columns.
  EXPECT_GT(added, 0.5 * 30.0 * 1.2 * std::pow(plot::pixels_per_point, 2));
  // 1600 columns of at most 4 points of at most 20 characters.
  EXPECT_LT(std::filesystem::file_size(path("spike.svg")), 128000U);
}

TEST_F(PlotTest, HistoriesDrawOneLinePerGauge) {
  TableCsv gauges(path("gauges.csv"),
                  {{"time", "s"}, {"left pressure", "Pa"}, {"right pressure", "Pa"}});
  for (int i = 0; i <= 10; ++i) {
    double const row[] = {i * 0.1, 1e5 + i, 1e5 + 10.0 - i};
    gauges.add(row);
  }
  plot_histories(path("gauges.csv"), path("a.png"));
  Picture const picture(path("a.png"));
  // Each line is at least 400 pt long and 1.2 pt wide; smoothing takes up to half of it.
  double const line = 400.0 * 1.2 * std::pow(plot::pixels_per_point, 2);
  EXPECT_GT(picture.count(plot::line_color(0)), 0.4 * line);
  EXPECT_GT(picture.count(plot::line_color(1)), 0.4 * line);
  EXPECT_LT(picture.count(plot::line_color(2)), 0.01 * line);
}

TEST_F(PlotTest, ErrorsAreClear) {
  EXPECT_NE(message_of<std::runtime_error>([&] {
              plot_run(path("none"), path("p"));
            }).find("no run folder"),
            std::string::npos);
  EXPECT_NE(message_of<std::runtime_error>([&] {
              plot_run(path(""), path("p"));
            }).find("nothing to plot"),
            std::string::npos);
  write_vtp(path("a.vtp"), halves(2, 4, 2), Kind::fluid, 0.0);
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              plot_frame(path("a.vtp"), "pressure", path("a.pdf"));
            }).find(".svg or .png"),
            std::string::npos);
  write_vtp(path("line.vtp"), halves(1, 4, 1), Kind::fluid, 0.0);
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              plot_frame(path("line.vtp"), "pressure", path("a.png"));
            }).find("plot a profile"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(PlotTest, RunGivesAllPictures) {
  PvdCollection pvd(path("particles.pvd"));
  for (int i = 0; i < 9; ++i) {
    std::string const file = "frames/particles_00000" + std::to_string(i) + ".vtp";
    write_vtp(path(file), halves(i % 2 == 0 ? 2 : 1, 8, i % 2 == 0 ? 4 : 1), Kind::fluid, i * 0.1);
    pvd.add(i * 0.1, file);
  }
  TableCsv gauges(path("gauges.csv"), {{"time", "s"}, {"wall pressure", "Pa"}});
  TableCsv sums(path("sums.csv"), {{"time", "s"},
                                   {"kinetic_energy", "J"},
                                   {"internal_energy", "J"},
                                   {"potential_energy", "J"},
                                   {"total_energy", "J"},
                                   {"momentum_x", "kg m/s"},
                                   {"momentum_y", "kg m/s"},
                                   {"momentum_z", "kg m/s"},
                                   {"time_step", "s"}});
  for (int i = 0; i < 3; ++i) {
    double const t = i;
    double const gauge[] = {t, 1e5 * t};
    double const sum[] = {t, t, 5.0 - t, 0.0, 5.0, 0.0, 0.0, 0.0, 0.1};
    gauges.add(gauge);
    sums.add(sum);
  }
  auto const written = plot_run(path(""), path("plots"));
  std::vector<std::string> names;
  for (auto const& file : written) {
    names.push_back(file.filename().string());
    EXPECT_GT(std::filesystem::file_size(file), 1000U) << file;
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "histories.svg", "histories.png", "sums.svg", "sums.png",
                       "pressure_particles_000000.png", "pressure_particles_000002.png",
                       "pressure_particles_000004.png", "pressure_particles_000006.png",
                       "pressure_particles_000008.png"}));
  // Nothing half-written stays behind.
  for (auto const& entry : std::filesystem::directory_iterator(path("plots")))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(PlotTest, ProfileShowsOneDimension) {
  write_vtp(path("a.vtp"), halves(1, 100, 1), Kind::fluid, 0.0);
  plot_profile(path("a.vtp"), "pressure", path("a.png"));
  // A hundred dots of 2.2 pt that do not overlap much (4 pt apart).
  double const dot = 3.8 * std::pow(plot::pixels_per_point, 2);
  EXPECT_GT(Picture(path("a.png")).count(plot::line_color(0)), 0.6 * 100.0 * dot);
}

}  // namespace
}  // namespace moraine
