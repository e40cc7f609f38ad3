#include "probes/body_probes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace moraine {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double radius_of(double volume, int dimension) {
  if (dimension == 1) return 0.5 * volume;
  if (dimension == 2) return std::sqrt(volume / std::numbers::pi);
  return std::cbrt(0.75 * volume / std::numbers::pi);
}

/// The box around the body, cut off at `within`.
PlaceBox box_around(BodyView const& view, PlaceBox const& within) {
  PlaceBox box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t i = 0; i < view.members.size(); ++i) {
    if (view.members[i] == 0) continue;
    Vec3 const x = particle_place(view.store, i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], x[axis]);
      box.max[axis] = std::max(box.max[axis], x[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::max(box.min[axis], within.min[axis]);
    box.max[axis] = std::min(box.max[axis], within.max[axis]);
  }
  return box;
}

/// Upper end of a particle above the base.
double end_above(ParticleStore const& store, std::size_t i, DepositFrame const& frame) {
  return frame.up.height(particle_place(store, i)) + 0.5 * size_of_particle(store, i) - frame.base;
}

double highest_end(ParticleStore const& store, std::span<std::uint8_t const> members,
                   DepositFrame const& frame) {
  double highest = -infinity;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (members[i] != 0) highest = std::max(highest, end_above(store, i, frame));
  return highest;
}

/// The farthest end of the particles that reach this height above the base.
double farthest_end(ParticleStore const& store, std::span<std::uint8_t const> members,
                    DepositFrame const& frame, double height) {
  double farthest = -infinity;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i] == 0 || end_above(store, i, frame) < height) continue;
    Vec3 away = subtract(particle_place(store, i), frame.origin);
    away[frame.up.axis] = 0.0;
    double const distance = frame.along ? frame.along->height(away) : norm(away);
    farthest = std::max(farthest, distance + 0.5 * size_of_particle(store, i));
  }
  return farthest;
}

}  // namespace

DepositReading probe_deposit(ParticleStore const& store, std::span<std::uint8_t const> members,
                             DepositFrame const& frame) {
  double const highest = highest_end(store, members, frame);
  if (highest == -infinity) return {nothing, nothing, nothing};
  double const run_out = farthest_end(store, members, frame, -infinity);
  double const half = 0.5 * highest;
  return {run_out, highest, std::atan2(half, run_out - farthest_end(store, members, frame, half))};
}

BubbleReading probe_bubble(ParticleStore const& store, Selection const& gas, int copies) {
  BubbleReading reading;
  reading.low = {infinity, infinity, infinity};
  reading.high = {-infinity, -infinity, -infinity};
  std::size_t const count = store.range(Kind::fluid).size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!gas.has(store, i)) continue;
    double const volume = store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
    double const half = 0.5 * size_of_particle(store, i);
    Vec3 const x = particle_place(store, i);
    reading.volume += volume;
    reading.center = add(reading.center, scale(volume, x));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reading.low[axis] = std::min(reading.low[axis], x[axis] - half);
      reading.high[axis] = std::max(reading.high[axis], x[axis] + half);
    }
  }
  if (reading.volume > 0.0) {
    reading.center = scale(1.0 / reading.volume, reading.center);
  } else {
    reading.center = reading.low = reading.high = {nothing, nothing, nothing};
  }
  reading.volume *= copies;
  reading.radius = radius_of(reading.volume, store.dimension());
  return reading;
}

double probe_highest(BodyView const& view, PlaceBox const& within) {
  PlaceBox const box = box_around(view, within);
  double const sign = view.up.sign;
  std::size_t const up = view.up.axis;
  double const bottom = sign > 0.0 ? box.min[up] : -box.max[up];
  double const highest = (sign > 0.0 ? box.max[up] : -box.min[up]) + 2.0 * view.h;
  double const top = std::min(highest, sign > 0.0 ? within.max[up] : -within.min[up]);
  std::array<int, 3> steps{};
  for (int axis = 0; axis < view.store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    if (!(box.min[k] <= box.max[k])) return nothing;
    if (k != up) steps[k] = static_cast<int>(std::ceil((box.max[k] - box.min[k]) / (0.5 * view.h)));
  }
  double best = -infinity;
  for (int i = 0; i <= steps[0]; ++i)
    for (int j = 0; j <= steps[1]; ++j)
      for (int k = 0; k <= steps[2]; ++k) {
        std::array const index{i, j, k};
        Vec3 place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double const share =
              steps[axis] > 0 ? static_cast<double>(index[axis]) / steps[axis] : 0.0;
          place[axis] = box.min[axis] + share * (box.max[axis] - box.min[axis]);
        }
        // Lower places than the best so far are of no interest.
        double const height = surface_height(view, place, top, std::max(best, bottom));
        if (height > best) best = height;
      }
  return best == -infinity ? nothing : best;
}

}  // namespace moraine
