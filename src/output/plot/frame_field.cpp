#include "output/plot/frame_field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace moraine::plot {
namespace {

constexpr std::string_view axis_names = "xyz";

std::vector<std::string> valid_names(ParticleFrame const& frame) {
  std::vector<std::string> names;
  for (FrameArray const& array : frame.arrays) {
    names.push_back(array.name);
    for (std::size_t axis = 0; array.components == 3 && axis < 3; ++axis)
      names.push_back(fmt::format("{}_{}", array.name, axis_names[axis]));
  }
  return names;
}

FrameField whole(FrameArray const& array, std::size_t size) {
  FrameField field{array.name, array.unit, array.values};
  if (array.components == 1) return field;
  field.name += " magnitude";
  field.values.assign(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    double square = 0.0;
    for (std::size_t c = 0; c < array.components; ++c) {
      double const component = array.values[i * array.components + c];
      square += component * component;
    }
    field.values[i] = std::sqrt(square);
  }
  return field;
}

}  // namespace

FrameField frame_field(ParticleFrame const& frame, std::string const& field) {
  if (FrameArray const* const array = frame.find(field)) return whole(*array, frame.size);
  for (FrameArray const& array : frame.arrays)
    for (std::size_t axis = 0; array.components == 3 && axis < 3; ++axis) {
      if (field != fmt::format("{}_{}", array.name, axis_names[axis])) continue;
      FrameField component{field, array.unit, std::vector<double>(frame.size)};
      for (std::size_t i = 0; i < frame.size; ++i) component.values[i] = array.values[i * 3 + axis];
      return component;
    }
  throw std::invalid_argument(fmt::format("no field '{}' in the frame; valid: {}", field,
                                          fmt::join(valid_names(frame), ", ")));
}

std::vector<double> spacings(ParticleFrame const& frame) {
  std::vector<double> result(frame.size, 0.0);
  FrameArray const* const mass = frame.find("mass");
  FrameArray const* const density = frame.find("density");
  if (mass == nullptr || density == nullptr) return result;
  for (std::size_t i = 0; i < frame.size; ++i) {
    double const volume = mass->values[i] / density->values[i];
    if (volume > 0.0 && std::isfinite(volume)) result[i] = std::pow(volume, 1.0 / frame.dimension);
  }
  return result;
}

double median_of_positive(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !(value > 0.0); });
  if (values.empty()) return 0.0;
  auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace moraine::plot
