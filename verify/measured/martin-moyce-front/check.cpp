// Front of a collapsing water column against measurements.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "probes/point_probe.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// T = t sqrt(2 g / a), Z = x / a; a = 2.25 inches, n^2 = 2. Martin & Moyce, Phil. Trans. R. Soc. A
/// 244 (1952) 312, digitised from their figure by third parties.
struct Sample {
  double time;
  double front;
};
constexpr std::array measured{Sample{0.832, 1.217},  Sample{1.219, 1.474},  Sample{1.997, 2.292},
                              Sample{2.547, 2.995},  Sample{3.345, 4.134},  Sample{4.034, 4.944},
                              Sample{4.418, 5.881},  Sample{5.091, 6.980},  Sample{5.685, 7.945},
                              Sample{6.306, 8.966},  Sample{6.822, 9.986},  Sample{7.439, 10.963},
                              Sample{8.031, 11.977}, Sample{8.633, 13.005}, Sample{9.237, 13.970}};

}  // namespace

std::vector<CheckResult> check_martin_moyce_front(Effort effort) {
  constexpr double a = 0.05715;  // m
  Case dam = shipped_case("dam-break-2d");
  double const g = -dam.gravity[1];
  if (effort == Effort::quick) dam.numerics.spacing *= 2.0;
  Simulation simulation(build_model(dam));
  std::vector<CheckResult> results;
  double time = 0.0;
  double front = 1.0;
  for (Sample const& point : measured) {
    double time_before = time;
    double front_before = front;
    while (simulation.running() && time < point.time) {
      simulation.advance();
      time_before = time;
      front_before = front;
      time = simulation.time() * std::sqrt(2.0 * g / a);
      // Particles stand for half a spacing ahead of their centres.
      front = (probe_front(simulation.particles(), 0, 0, +1) + 0.5 * dam.numerics.spacing) / a;
    }
    double const share = time > time_before ? (point.time - time_before) / (time - time_before) : 0;
    double const at = front_before + share * (front - front_before);
    results.push_back(compare(fmt::format("martin-moyce-front: T = {:.2f}", point.time), at,
                              point.front, 0.08 * point.front, "a", "no gate in the model"));
  }
  // The speed does not depend on when the clock was started.
  auto const speed = [](double front_1, double front_2) {
    return (front_2 - front_1) / (measured.back().time - measured[2].time);
  };
  double const reference = speed(measured[2].front, measured.back().front);
  results.push_back(compare("martin-moyce-front: speed",
                            speed(results[2].measured, results.back().measured), reference,
                            0.08 * reference, "-", "dZ/dT from T = 2.00 to 9.24"));
  return results;
}

}  // namespace moraine
