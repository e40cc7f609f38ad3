// Supports of single particles, where they vary.
#include <algorithm>

#include "base/parallel_for.hpp"
#include "search/search.hpp"

namespace moraine {

void Search::read_supports(ParticleStore const& store) {
  if (!varies()) return;
  auto const h = store.scalar(Field::smoothing_length);
  auto& support = points(Kind::fluid).support;
  support.resize(h.size() + CellPoints::padding);
  double const factor = settings_.supports / settings_.fixed_point.scale;
  for_each_block(h.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) support[i] = static_cast<float>(factor * h[i]);
  });
}

/// By how much a support has grown most since the lists were made [units].
double Search::growth_of_supports() const {
  if (!varies()) return 0.0;
  auto const& support = points(Kind::fluid).support;
  auto const in_block = [&](std::size_t begin, std::size_t end) {
    float most = 0.0F;
    for (std::size_t i = begin; i < end; ++i)
      most = std::max(most, support[i] - listed_support_[i]);
    return most;
  };
  return reduce_blocks(listed_support_.size(), 0.0F, in_block,
                       [](float a, float b) { return std::max(a, b); });
}

void Search::list_supports(ParticleStore const& store) {
  if (!varies()) return;
  read_supports(store);
  auto const& support = points(Kind::fluid).support;
  listed_support_.assign(support.begin(), support.end() - CellPoints::padding);
}

void Search::find_largest_support(ParticleStore const& store) {
  if (!varies()) return;
  double largest = 0.0;
  for (double const h : store.scalar(Field::smoothing_length)) largest = std::max(largest, h);
  // A hair more than its rounding to single precision.
  largest_support_ = largest * settings_.supports / settings_.fixed_point.scale * (1.0 + 1e-6);
}

}  // namespace moraine
