// The value of each particle that a plot shows.
#pragma once

#include <string>
#include <vector>

#include "output/vtp_reader.hpp"

namespace moraine::plot {

/// One number per particle.
struct FrameField {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// A scalar, the magnitude of a vector, or a component (`velocity_x`). Throws std::invalid_argument
/// listing the valid names if there is no such field.
FrameField frame_field(ParticleFrame const& frame, std::string const& field);

/// Distance between neighbours [m] that fits each particle's volume, (m/rho)^(1/dimension); zero
/// where mass or density is not positive or not in the frame.
std::vector<double> spacings(ParticleFrame const& frame);

/// Middle of the positive values, zero if there are none.
double median_of_positive(std::vector<double> values);

}  // namespace moraine::plot
