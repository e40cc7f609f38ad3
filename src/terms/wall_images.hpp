// What images of the fluid at mirror walls differ in from those at symmetry planes.
#pragma once

#include <array>

#include "search/search.hpp"
#include "terms/records.hpp"
#include "terms/sweep_parameters.hpp"

namespace moraine {

/// Continues an image at a wall with hydrostatics,
///
///   p' = p + rho g . (x' - x),   rho' = rho + rho_0 g . (x' - x) / c_0^2,
///   d rho'/dx' = - d rho/dx + 2 rho_0 g / c_0^2   along each axis across a wall,
///
/// counted along those axes; `fall` is x' - x there [m], zero along others. Without it the pressure
/// would have a kink at a floor, where its gradient must bear the weight of the water. As in
/// wall_extrapolation.hpp; c_0 as in density_diffusion.hpp, for which such water is at rest.
/// A gradient has been reflected with its image: what is added is the second part of its line.
template <class Slot, class Layout>
void continue_into_image(Records<Slot, Layout>& fluid, std::size_t i,
                         std::array<double, 3> const& fall, SweepParameters const& p) {
  double head = 0.0;    // g . (x' - x) [m^2/s^2]
  double denser = 0.0;  // (rho' - rho) / rho_0
  for (std::size_t axis = 0; axis < 3; ++axis) {
    head += p.gravity[axis] * fall[axis];
    denser += p.image_slope[axis] * fall[axis];
  }
  if (head == 0.0 || !Layout::has(PairField::compression)) return;
  double rho_0 = p.uniform[static_cast<std::size_t>(PairField::reference_density)];
  if constexpr (Layout::has(PairField::reference_density))
    rho_0 = fluid.get(i, PairField::reference_density);
  double const compression = fluid.get(i, PairField::compression);
  fluid.set(i, PairField::compression, compression + denser);
  if constexpr (Layout::has(PairField::pressure_term)) {
    double const rho = rho_0 * (1.0 + compression);
    double const rho_image = rho + rho_0 * denser;
    double const pressure = fluid.get(i, PairField::pressure_term) * rho * rho + rho * head;
    fluid.set(i, PairField::pressure_term, pressure / (rho_image * rho_image));
  }
  if constexpr (Layout::has(PairField::density_gradient))
    for (int axis = 0; axis < Layout::dimension; ++axis) {
      auto const a = static_cast<std::size_t>(axis);
      if (fall[a] == 0.0) continue;
      double const reflected = fluid.get(i, PairField::density_gradient, axis);
      fluid.set(i, PairField::density_gradient, reflected + 2.0 * rho_0 * p.image_slope[a], axis);
    }
}

/// Gravity, and velocities: the image of a particle at a no-slip wall has all of the velocity
/// reversed, and its shear stress as it is; of several reflections each does its part.
template <class Slot, class Layout>
void adjust_wall_images(Records<Slot, Layout>& fluid, std::vector<Image> const& images,
                        SearchSettings const& search, SweepParameters const& parameters) {
  constexpr auto axes = static_cast<std::size_t>(Layout::dimension);
  DomainSides const& sides = search.sides;
  for_each_block(images.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!sides.at_wall(images[k])) continue;
      std::size_t const i = fluid.owned() + k;
      std::array<double, 3> fall{};
      for (std::size_t axis = 0; axis < axes; ++axis) {
        Plane const plane = sides.plane_of(images[k].shift[axis], axis);
        if (plane <= Plane::symmetry) continue;
        fall[axis] = metres_between(fluid.record(i)[axis], fluid.record(images[k].source)[axis],
                                    search.fixed_point.scale);
        if (plane != Plane::stick_wall) continue;
        for (std::size_t along = 0; along < axes; ++along)
          if (along != axis) fluid.reverse_velocity(i, along);
        fluid.reverse_stresses(i, axis);
      }
      continue_into_image(fluid, i, fall, parameters);
    }
  });
}

/// Copies records of the fluid to all their images, at symmetry planes, periods and walls.
template <class Slot, class Layout>
void refresh_images(Records<Slot, Layout>& fluid, Search const& search,
                    SweepParameters const& parameters) {
  auto const& images = search.images(Kind::fluid);
  fluid.refresh(images, search.settings().sides);
  if (search.settings().sides.any_wall())
    adjust_wall_images(fluid, images, search.settings(), parameters);
}

}  // namespace moraine
