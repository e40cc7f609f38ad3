// Integrals of smooth pieces of exact solutions.
#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <initializer_list>

namespace moraine {

/// The integral of `f` over consecutive intervals, inside of which it is smooth, estimated to
/// 1e-11: what comes out is better by a few digits.
template <class F>
double integral(F const& f, std::initializer_list<double> edges) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  double sum = 0.0;
  for (double const* edge = edges.begin(); edge + 1 < edges.end(); ++edge)
    sum += Rule::integrate(f, edge[0], edge[1], 10, 1e-11);
  return sum;
}

}  // namespace moraine
