// Front of a collapsing water column against measurements.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "probes/point_probe.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// T = t sqrt(2 g / a), Z = x / a; a = 2.25 inches, n^2 = 2.
struct Sample {
  double time;
  double front;
};

/// Martin & Moyce, Phil. Trans. R. Soc. A 244 (1952) 312, table 2.
constexpr std::array table{Sample{0.41, 1.11}, Sample{0.84, 1.22}, Sample{1.19, 1.44},
                           Sample{1.43, 1.67}, Sample{1.63, 1.89}, Sample{1.83, 2.11},
                           Sample{1.98, 2.33}, Sample{2.20, 2.56}, Sample{2.32, 2.78},
                           Sample{2.51, 3.00}, Sample{2.65, 3.22}, Sample{2.83, 3.44},
                           Sample{2.98, 3.67}, Sample{3.11, 3.89}, Sample{3.33, 4.11}};

/// The same, figure 3, beyond the table; digitised by third parties.
constexpr std::array figure{Sample{4.034, 4.944},  Sample{4.418, 5.881},  Sample{5.091, 6.980},
                            Sample{5.685, 7.945},  Sample{6.306, 8.966},  Sample{6.822, 9.986},
                            Sample{7.439, 10.963}, Sample{8.031, 11.977}, Sample{8.633, 13.005},
                            Sample{9.237, 13.970}};

/// The reading at which the clocks are set, and the first one that counts.
constexpr std::size_t first = 2;
constexpr Sample reference = table[first];

/// Dimensionless path of the front of a simulated dam break.
class FrontPath {
 public:
  FrontPath(Case const& dam, double a) {
    Simulation simulation(build_model(dam));
    double const unit = std::sqrt(-2.0 * dam.gravity[1] / a);
    // Particles stand for half a spacing ahead of their centres.
    auto const front = [&] {
      return (probe_front(simulation.particles(), 0, 0, +1) + 0.5 * dam.numerics.spacing) / a;
    };
    path_.push_back({0.0, front()});
    while (simulation.running()) {
      simulation.advance();
      path_.push_back({simulation.time() * unit, front()});
    }
  }

  /// Front at a time, and first time at a front; linear between steps.
  double at(double time) const { return interpolate(time, &Sample::time, &Sample::front); }
  double when(double front) const { return interpolate(front, &Sample::front, &Sample::time); }

 private:
  double interpolate(double x, double Sample::*from, double Sample::*to) const {
    auto const after =
        std::find_if(path_.begin() + 1, path_.end(), [&](Sample const& s) { return s.*from >= x; });
    if (after == path_.end()) return std::numeric_limits<double>::quiet_NaN();
    Sample const& b = *after;
    Sample const& a = *(after - 1);
    return a.*to + (b.*to - a.*to) * (x - a.*from) / (b.*from - a.*from);
  }

  std::vector<Sample> path_;
};

/// Slope of the straight line Z(T) nearest to the samples, least squares.
double slope(std::span<Sample const> samples) {
  double n = 0.0, t = 0.0, z = 0.0, tt = 0.0, tz = 0.0;
  for (Sample const& s : samples) {
    n += 1.0;
    t += s.time;
    z += s.front;
    tt += s.time * s.time;
    tz += s.time * s.front;
  }
  return (n * tz - t * z) / (n * tt - t * t);
}

/// Mean speed over a part of the way; no clock has a say in it.
CheckResult speed(FrontPath const& path, std::span<Sample const> samples) {
  std::vector<Sample> computed;
  for (Sample const& s : samples) computed.push_back({path.when(s.front), s.front});
  double const expected = slope(samples);
  return compare(fmt::format("martin-moyce-front: speed, Z = {:.2f} to {:.2f}",
                             samples.front().front, samples.back().front),
                 slope(computed), expected, 0.08 * expected, "a/T", "whatever the clock");
}

/// Largest relative difference of the front over the samples, with the clock set late.
CheckResult position(FrontPath const& path, std::span<Sample const> samples, double late) {
  double worst = 0.0, at = 0.0, unset = 0.0;
  for (Sample const& s : samples) {
    double const difference = path.at(s.time - late) / s.front - 1.0;
    double const without = path.at(s.time) / s.front - 1.0;
    if (!(std::fabs(difference) <= std::fabs(worst))) worst = difference, at = s.time;
    if (!(std::fabs(without) <= std::fabs(unset))) unset = without;
  }
  return at_most(fmt::format("martin-moyce-front: place, Z = {:.2f} to {:.2f}",
                             samples.front().front, samples.back().front),
                 worst, 0.08, "-",
                 fmt::format("largest, at T = {:.2f}; without setting the clock {:+.1f} %", at,
                             100.0 * unset));
}

}  // namespace

std::vector<CheckResult> check_martin_moyce_front(Effort effort) {
  constexpr double a = 0.05715;  // m
  Case dam = shipped_case("dam-break-2d");
  if (effort == Effort::quick) dam.numerics.spacing *= 2.0;
  FrontPath const path(dam, a);
  double const late = reference.time - path.when(reference.front);
  std::span const early = std::span(table).subspan(first);
  return {speed(path, early.first(8)), speed(path, early.last(9)), speed(path, figure),
          // Experiments with this column differ by 0.16 in when the front passes (README.md).
          at_most("martin-moyce-front: clock", late, 0.32, "T",
                  fmt::format("measured minus computed time at Z = {:.2f}", reference.front)),
          position(path, early.subspan(1), late), position(path, figure, late)};
}

}  // namespace moraine
