#include "probes/reading_summary.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace moraine {

void ReadingSummary::add(double time, double value) {
  double const before = last_;
  double const dt = time - last_time_;
  last_ = value;
  last_time_ = time;
  if (std::isnan(value)) return;
  if (std::isnan(first_)) {
    first_ = value;
    largest_ = smallest_ = value;
    time_of_largest_ = time_of_smallest_ = time;
  }
  if (value > largest_) {
    largest_ = value;
    time_of_largest_ = time;
    fall_back_ = nothing;
  }
  if (value < smallest_) {
    smallest_ = value;
    time_of_smallest_ = time;
  }
  bool const joined = !std::isnan(before);
  if (joined) {
    integral_ += 0.5 * dt * (before + value);
    rise_integral_ += 0.5 * dt * (before + value - 2.0 * first_);
  }
  if (std::isnan(arrival_) && value - first_ >= rise_) {
    double const rise = value - before;
    arrival_ = joined ? time - dt * (value - first_ - rise_) / rise : time;
  }
  // After an arrival the largest reading is above the first one; so is the reading before the fall.
  if (!std::isnan(arrival_) && std::isnan(fall_back_) && value <= first_)
    fall_back_ = joined ? time - dt * (first_ - value) / (before - value) : time;
}

void ReadingSummary::exchange(Archive& archive, std::string const& name) {
  std::array const pieces{&first_,           &last_,          &last_time_,        &largest_,
                          &time_of_largest_, &smallest_,      &time_of_smallest_, &arrival_,
                          &integral_,        &rise_integral_, &fall_back_};
  std::vector<double> values;
  for (double const* piece : pieces) values.push_back(*piece);
  archive.array(name, "", values);
  for (std::size_t k = 0; k < pieces.size(); ++k) *pieces[k] = values.at(k);
}

}  // namespace moraine
