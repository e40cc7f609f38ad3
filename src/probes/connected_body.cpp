#include "probes/connected_body.hpp"

#include <algorithm>
#include <numeric>

#include "probes/selection.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {
namespace {

/// Groups of indices that were joined (union-find with path halving; the least index leads).
class Groups {
 public:
  explicit Groups(std::size_t count) : leader_(count) {
    std::iota(leader_.begin(), leader_.end(), 0U);
  }
  std::uint32_t of(std::uint32_t i) {
    while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    leader_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> leader_;
};

double length_of(ParticleStore const& store, std::size_t i, double h) {
  return store.has(Field::smoothing_length) ? store.scalar(Field::smoothing_length)[i] : h;
}

/// Distance squared from particle i to a point of the lists: an owned particle or an image of one.
double distance2(ParticleStore const& store, Search const& search, std::size_t i,
                 std::uint32_t source, Image const* image) {
  double sum = 0.0;
  for (int axis = 0; axis < store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    double x = store.component(Field::position, axis)[source];
    if (image != nullptr && image->shift[k] != 0)
      x = search.settings().sides.image_place(x, image->shift[k], k);
    double const d = store.component(Field::position, axis)[i] - x;
    sum += d * d;
  }
  return sum;
}

void join_neighbours(ParticleStore const& store, Search const& search, double h,
                     std::span<std::uint8_t const> chosen, Groups& groups) {
  auto const& images = search.images(Kind::fluid);
  std::size_t const owned = chosen.size();
  for (std::size_t i = 0; i < owned; ++i) {
    if (chosen[i] == 0) continue;
    for (std::uint32_t const j : search.fluid_fluid().points(i)) {
      Image const* const image = j < owned ? nullptr : &images[j - owned];
      std::uint32_t const source = image == nullptr ? j : image->source;
      if (chosen[source] == 0) continue;
      double const reach =
          0.5 * kernel_support * (length_of(store, i, h) + length_of(store, source, h));
      if (distance2(store, search, i, source, image) < reach * reach)
        groups.join(static_cast<std::uint32_t>(i), source);
    }
  }
}

}  // namespace

ConnectedBody connected_body(ParticleStore const& store, Search const& search, double h,
                             std::span<std::uint8_t const> chosen) {
  Groups groups(chosen.size());
  join_neighbours(store, search, h, chosen, groups);
  std::vector<double> mass(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0)
      mass[groups.of(static_cast<std::uint32_t>(i))] += store.scalar(Field::mass)[i];
  auto const heaviest =
      static_cast<std::uint32_t>(std::max_element(mass.begin(), mass.end()) - mass.begin());
  ConnectedBody body;
  body.members.resize(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i] == 0) continue;
    bool const inside = groups.of(static_cast<std::uint32_t>(i)) == heaviest;
    body.members[i] = inside ? 1 : 0;
    ++(inside ? body.particles : body.detached);
    (inside ? body.mass : body.detached_mass) += store.scalar(Field::mass)[i];
  }
  return body;
}

}  // namespace moraine
