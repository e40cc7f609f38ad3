#include "search/side_images.hpp"

namespace moraine {
namespace {

/// Whether a point at x [units] has an image with this shift.
bool has_image(DomainSides const& sides, std::int64_t x, int shift, std::size_t axis,
               std::int64_t reach) {
  std::int64_t const low = sides.low_units[axis];
  std::int64_t const high = low + sides.length_units[axis];
  bool const near_low = x < low + reach;
  bool const near_high = x >= high - reach;
  if (sides.periodic[axis]) return shift > 0 ? near_low : near_high;
  return sides.reflects(axis, shift > 0 ? 1 : 0) && (shift > 0 ? near_high : near_low);
}

}  // namespace

void append_images(DomainSides const& sides, int dimension, std::int64_t reach,
                   std::array<std::vector<Units>, 3>& points, std::vector<std::uint64_t>& key,
                   std::vector<Image>& images) {
  std::size_t const owned = key.size();
  images.clear();
  for (std::size_t i = 0; i < key.size(); ++i)
    images.push_back({static_cast<std::uint32_t>(i), {0, 0, 0}});
  // Axis by axis, so that the images made along x get images along y: edges and corners follow.
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    if (!sides.periodic[axis] && !sides.reflects(axis)) continue;
    std::size_t const count = images.size();
    for (std::size_t k = 0; k < count; ++k) {
      Units const x = points[axis][k];
      for (int const shift : {+1, -1}) {
        if (!has_image(sides, x, shift, axis, reach)) continue;
        for (std::size_t other = 0; other < static_cast<std::size_t>(dimension); ++other) {
          Units const value = points[other][k];
          points[other].push_back(other == axis ? sides.image_units(value, shift, axis) : value);
        }
        Image image = images[k];
        image.shift[axis] = static_cast<std::int8_t>(shift);
        images.push_back(image);
        key.push_back(key.size() + (std::uint64_t{1} << 63));
      }
    }
  }
  images.erase(images.begin(), images.begin() + static_cast<std::ptrdiff_t>(owned));
}

}  // namespace moraine
