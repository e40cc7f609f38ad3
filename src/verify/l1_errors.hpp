// How far a run is from an exact solution.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "exact/flow_state.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Relative L1 errors: the sum of weight |f - exact| over particles, divided by the sum of weight
/// |exact|. Density and pressure are weighted with volumes, velocity with masses: an integral of
/// the error over space, and one over what moves (thin gas fills much space and carries little).
struct L1Errors {
  double density = 0.0;
  double velocity = 0.0;
  double pressure = 0.0;
};

/// The coordinate of a flow, and the component of velocity that belongs to it.
enum class FlowCoordinate { x, distance_from_origin };

/// What should be at a coordinate [m]; nothing: that place is not compared.
using ExactFlow = std::function<std::optional<FlowState>(double)>;

/// Errors of the fluid as it is now.
L1Errors l1_errors(Simulation const& simulation, FlowCoordinate coordinate, ExactFlow const& exact);

/// Two spacings [m] that a check compares.
struct SpacingPair {
  double coarse = 0.0;
  double fine = 0.0;
  double ratio() const { return coarse / fine; }
};

/// "at 20 and 10 mm".
std::string in_words(SpacingPair const& spacings);

/// Order of convergence between two spacings, the coarse one `ratio` times the fine one.
double convergence_order(double coarse_error, double fine_error, double ratio = 2.0);

/// The limit of values at these spacings whose error is of first order.
double first_order_limit(double coarse, double fine, double ratio = 2.0);

/// The case, run to its end.
Simulation run_to_end(Case const& c);

}  // namespace moraine
