#include "matter/point/load_path.hpp"

#include <cmath>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

Deformation stretch(double x, double y, double z) { return {{x, y, z, 0.0, 0.0, 0.0}, {}}; }

/// Simple shear by the angle `gamma` in one step: v_x = gamma y.
Deformation simple_shear(double gamma) {
  return {{0.0, 0.0, 0.0, 0.5 * gamma, 0.0, 0.0}, {0.0, 0.0, -0.5 * gamma}};
}

/// The strain across at which the stress along y is -`confinement`.
double strain_across(MaterialElement const& point, ElementState const& state, double axial,
                     bool along_z_too, double confinement) {
  auto const excess = [&](double across) {
    auto const next = point.after(state, stretch(axial, across, along_z_too ? across : 0.0));
    return next.stress()[1] + confinement;
  };
  for (double reach = 2.0 * std::fabs(axial); reach < 0.5; reach *= 4.0)
    if (excess(-reach) <= 0.0 && excess(reach) >= 0.0) return bisect(excess, -reach, reach);
  throw std::domain_error(
      "no strain across holds the stress there: the material has no such state");
}

Deformation next_deformation(MaterialElement const& point, ElementState const& state,
                             Loading const& loading, double strain) {
  switch (loading.path) {
    case LoadPath::hydrostatic:
      return stretch(-strain, -strain, -strain);
    case LoadPath::uniaxial:
      return stretch(-strain, 0.0, 0.0);
    case LoadPath::triaxial: {
      double const across = strain_across(point, state, -strain, true, loading.confinement);
      return stretch(-strain, across, across);
    }
    case LoadPath::biaxial:
      return stretch(-strain, strain_across(point, state, -strain, false, loading.confinement),
                     0.0);
    case LoadPath::shear:
      return simple_shear(strain);
  }
  return {};
}

}  // namespace

std::vector<ElementState> follow(MaterialElement const& point, Loading const& loading) {
  std::vector<ElementState> states{point.at_pressure(loading.confinement)};
  double const strain = loading.strain / loading.steps;
  for (int k = 0; k < loading.steps; ++k)
    states.push_back(
        point.after(states.back(), next_deformation(point, states.back(), loading, strain)));
  return states;
}

}  // namespace moraine
