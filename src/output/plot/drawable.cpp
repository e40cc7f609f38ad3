#include "output/plot/drawable.hpp"

#include <cmath>
#include <limits>

namespace moraine::plot {
namespace {

constexpr double largest = 1e100;

double drawable(double value) {
  if (std::abs(value) > largest) return std::numeric_limits<double>::quiet_NaN();
  return std::abs(value) < 1.0 / largest ? 0.0 : value;
}

}  // namespace

void make_drawable(std::vector<double>& values) {
  for (double& value : values) value = drawable(value);
}

Table read_drawable_table(std::filesystem::path const& csv) {
  Table table = read_table_csv(csv);
  for (auto& values : table.values) make_drawable(values);
  return table;
}

ParticleFrame read_drawable_frame(std::filesystem::path const& vtp) {
  ParticleFrame frame = read_vtp(vtp);
  frame.time = drawable(frame.time);
  make_drawable(frame.points.values);
  for (FrameArray& array : frame.arrays) make_drawable(array.values);
  return frame;
}

}  // namespace moraine::plot
