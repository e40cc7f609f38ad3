#include "blast/line_charge.hpp"

#include <array>
#include <cmath>

namespace moraine::blast {
namespace {

/// ln(R/R_0), ln(p/p_a) and the slope between them.
struct Row {
  double distance;
  double overpressure;
  double slope;
};

constexpr std::array<Row, 13> table{{
    {-6.33204, 11.11155, -1.99996},
    {-4.26892, 6.98635, -1.99788},
    {-3.2461, 4.94774, -1.98399},
    {-2.51353, 3.50819, -1.936},
    {-1.79783, 2.16579, -1.79399},
    {-1.19681, 1.1482, -1.58189},
    {-0.6189, 0.29902, -1.36054},
    {0.02764, -0.51294, -1.16221},
    {0.82842, -1.37383, -1.00154},
    {1.82922, -2.3136, -0.88848},
    {3.05183, -3.35194, -0.81851},
    {4.60743, -4.58931, -0.77818},
    {6.63734, -6.1453, -0.75855},
}};

double hermite(Row const& a, Row const& b, double x) {
  double const h = b.distance - a.distance;
  double const s = (x - a.distance) / h, r = 1.0 - s;
  return (1.0 + 2.0 * s) * r * r * a.overpressure + s * r * r * h * a.slope +
         s * s * (3.0 - 2.0 * s) * b.overpressure - s * s * r * h * b.slope;
}

}  // namespace

double line_scaled_distance(double charge_mass, double length, double distance) {
  return distance * std::sqrt(length / charge_mass);
}

double sachs_length(Source source, double energy, double length, double ambient_pressure) {
  int const theta = static_cast<int>(source);
  return std::pow(energy / (ambient_pressure * std::pow(length, 3 - theta)), 1.0 / theta);
}

double line_source_overpressure(double distance_over_sachs_length) {
  double const x = std::log(distance_over_sachs_length);
  if (x <= table.front().distance)
    return std::exp(table.front().overpressure +
                    table.front().slope * (x - table.front().distance));
  for (std::size_t i = 1; i < table.size(); ++i)
    if (x <= table[i].distance) return std::exp(hermite(table[i - 1], table[i], x));
  return std::exp(table.back().overpressure + table.back().slope * (x - table.back().distance));
}

}  // namespace moraine::blast
