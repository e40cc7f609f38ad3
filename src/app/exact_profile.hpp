// Profiles and numbers that several exact solutions answer with.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/exact_solution.hpp"
#include "exact/flow_state.hpp"
#include "exact/riemann.hpp"

namespace moraine {

/// An empty table, and a row more of it.
Table table_of(std::vector<TableColumn> columns);
void add_row(Table& table, std::initializer_list<double> row);

/// Density, velocity, pressure and specific energy at the places `x` [m]; `axis` is their name.
Table flow_profile(std::string const& axis, std::vector<double> const& x,
                   std::function<FlowState(double)> const& sample);

/// Star states and places of the waves of a Riemann problem whose discontinuity was at x = `origin`
/// [m], at `time` [s].
std::vector<ExactNumber> riemann_numbers(RiemannProblem const& solution, double time,
                                         double origin);

/// Places that show all waves of a Riemann problem at `time`, around `origin`.
std::vector<double> riemann_places(RiemannProblem const& solution, double time, double origin,
                                   int count);

}  // namespace moraine
