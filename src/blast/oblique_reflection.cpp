#include "blast/oblique_reflection.hpp"

#include <cmath>
#include <numbers>

#include "base/bisect.hpp"
#include "blast/front.hpp"
#include "blast/oblique_shock.hpp"

namespace moraine::blast {
namespace {

constexpr double right_angle = std::numbers::pi / 2.0;
constexpr double head_on = 1e-6;  // rad; below, reflection differs from normal by its square

/// The stream behind the incident front, seen from a point that moves with it.
struct Stream {
  double mach_squared;
  double turned;  // rad, towards the wall
};

/// `angle` lies between the front and the way of the point.
Stream behind_front(double pressure_ratio, double angle) {
  double const sine = std::sin(angle);
  double const ahead = normal_mach_squared(pressure_ratio) / (sine * sine);
  return {mach_squared_behind(pressure_ratio, ahead), deflection(pressure_ratio, ahead)};
}

/// Whether a second front can turn the stream back.
bool attached(Stream const& stream) {
  if (!(stream.mach_squared > 1.0)) return false;
  return deflection(detachment_ratio(stream.mach_squared), stream.mach_squared) >= stream.turned;
}

/// Stem and mismatch of direction for a triple point that leaves the wall at `path_angle`.
struct TriplePoint {
  double stem_ratio;
  std::optional<double> mismatch;  // rad; none where the reflected front cannot be
};

TriplePoint triple_point(double pressure_ratio, double angle, double path_angle) {
  Stream const stream = behind_front(pressure_ratio, angle - path_angle);
  double const sine = std::sin(angle - path_angle), cosine = std::cos(path_angle);
  double const ahead = normal_mach_squared(pressure_ratio) / (sine * sine);
  double const stem = strongest_ratio(ahead * cosine * cosine);
  double const reflected = stem / pressure_ratio;
  if (!(stream.mach_squared > 1.0) || reflected < 1.0 ||
      reflected > strongest_ratio(stream.mach_squared))
    return {stem, std::nullopt};
  return {stem,
          stream.turned - deflection(reflected, stream.mach_squared) - deflection(stem, ahead)};
}

}  // namespace

std::optional<double> regular_reflection(double overpressure, double ambient_pressure,
                                         double angle) {
  if (angle < head_on) return normal_reflection(overpressure, ambient_pressure);
  double const ratio = 1.0 + overpressure / ambient_pressure;
  Stream const stream = behind_front(ratio, angle);
  if (!attached(stream)) return std::nullopt;
  double const reflected =
      bisect([&](double eta) { return deflection(eta, stream.mach_squared) - stream.turned; }, 1.0,
             detachment_ratio(stream.mach_squared));
  return ambient_pressure * (ratio * reflected - 1.0);
}

double extreme_angle(double overpressure, double ambient_pressure) {
  double const ratio = 1.0 + overpressure / ambient_pressure;
  return bisect([&](double angle) { return attached(behind_front(ratio, angle)) ? -1.0 : 1.0; },
                head_on, right_angle);
}

std::optional<MachStem> mach_reflection(double overpressure, double ambient_pressure,
                                        double angle) {
  // The mismatch has no value beyond some path angle, and a root without meaning where the path
  // nears the incident front: search from zero to the middle.
  constexpr int steps = 1000;
  double const ratio = 1.0 + overpressure / ambient_pressure;
  auto const mismatch = [&](double path) { return triple_point(ratio, angle, path).mismatch; };
  for (int k = 0; k < steps; ++k) {
    double const low = 0.5 * angle * k / steps, high = 0.5 * angle * (k + 1) / steps;
    auto const at_low = mismatch(low), at_high = mismatch(high);
    if (!at_low || !at_high || (*at_low < 0.0) == (*at_high < 0.0)) continue;
    double const path = bisect([&](double x) { return mismatch(x).value_or(0.0); }, low, high);
    return MachStem{ambient_pressure * (triple_point(ratio, angle, path).stem_ratio - 1.0), path};
  }
  return std::nullopt;
}

}  // namespace moraine::blast
