#include "probes/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"

namespace moraine {

void PressureEnvelope::start(ParticleStore const& store, double time) {
  std::uint64_t largest_id = 0;
  Range const fluid = store.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    largest_id = std::max(largest_id, store.id()[i]);
  std::size_t const count = fluid.size() > 0 ? largest_id + 1 : 0;
  start_.assign(count, 0.0);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    start_[store.id()[i]] = store.scalar(Field::pressure)[i];
  last_ = start_;
  peak_ = start_;
  time_of_peak_.assign(count, time);
  arrival_.assign(count, std::numeric_limits<double>::quiet_NaN());
  impulse_.assign(count, 0.0);
  last_time_ = time;
}

void PressureEnvelope::tell(ParticleStore const& store, double time) {
  if (start_.empty()) return start(store, time);
  double const dt = time - last_time_;
  auto const id = store.id();
  auto const pressure = store.scalar(Field::pressure);
  for_each_block(store.range(Kind::fluid).size(), loop_block,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     std::size_t const k = id[i];
                     double const before = last_[k] - start_[k];
                     double const now = pressure[i] - start_[k];
                     impulse_[k] += 0.5 * dt * (before + now);
                     // Before the arrival the rise is below the bound, hence now > before.
                     if (std::isnan(arrival_[k]) && now >= rise_)
                       arrival_[k] = last_time_ + dt * (rise_ - before) / (now - before);
                     if (pressure[i] > peak_[k]) {
                       peak_[k] = pressure[i];
                       time_of_peak_[k] = time;
                     }
                     last_[k] = pressure[i];
                   }
                 });
  last_time_ = time;
}

void PressureEnvelope::exchange(Archive& archive) {
  archive.number("envelope/last_time", last_time_);
  archive.array("envelope/start", "Pa", start_);
  archive.array("envelope/last", "Pa", last_);
  archive.array("envelope/peak", "Pa", peak_);
  archive.array("envelope/time_of_peak", "s", time_of_peak_);
  archive.array("envelope/arrival", "s", arrival_);
  archive.array("envelope/impulse", "Pa s", impulse_);
}

}  // namespace moraine
