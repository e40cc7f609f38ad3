// Envelopes of particles and of readings follow signals whose extremes and integrals are known.
#include "probes/envelope.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "probes/reading_summary.hpp"

namespace moraine {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Two particles with these pressures.
ParticleStore pair_of(double first, double second) {
  ParticleStore store(1);
  store.append(Kind::fluid, 0);
  store.append(Kind::fluid, 0);
  store.scalar(Field::pressure)[0] = first;
  store.scalar(Field::pressure)[1] = second;
  return store;
}

TEST(Envelope, FollowsEachParticleByItsId) {
  PressureEnvelope envelope(50.0);
  ParticleStore store = pair_of(100.0, 200.0);
  envelope.tell(store, 0.0);
  store.scalar(Field::pressure)[0] = 300.0;  // passes 150 after a quarter of the step
  envelope.tell(store, 1.0);
  std::array<std::uint32_t, 2> const swapped{1, 0};
  store.permute(Kind::fluid, swapped);
  store.scalar(Field::pressure)[1] = 120.0;  // still the first particle
  envelope.tell(store, 3.0);
  EXPECT_EQ(envelope.peak()[0], 300.0);
  EXPECT_EQ(envelope.time_of_peak()[0], 1.0);
  EXPECT_DOUBLE_EQ(envelope.arrival()[0], 0.25);
  EXPECT_DOUBLE_EQ(envelope.impulse()[0], 0.5 * 200.0 + 2.0 * 0.5 * (200.0 + 20.0));
  EXPECT_EQ(envelope.peak()[1], 200.0);
  EXPECT_EQ(envelope.time_of_peak()[1], 0.0);
  EXPECT_TRUE(std::isnan(envelope.arrival()[1]));
  EXPECT_EQ(envelope.impulse()[1], 0.0);
}

TEST(Envelope, KeepsWhatALostParticleHad) {
  PressureEnvelope envelope(50.0);
  ParticleStore store = pair_of(100.0, 200.0);
  envelope.tell(store, 0.0);
  std::array<std::uint32_t, 1> const lost{1};
  store.remove(lost);
  store.scalar(Field::pressure)[0] = 101.0;
  envelope.tell(store, 1.0);
  EXPECT_EQ(envelope.peak()[0], 101.0);
  EXPECT_EQ(envelope.peak()[1], 200.0);
}

TEST(ReadingSummary, KnowsExtremesIntegralAndArrival) {
  ReadingSummary summary;
  summary.set_rise(3.0);
  summary.add(0.0, 1.0);
  summary.add(1.0, 5.0);
  summary.add(3.0, -1.0);
  EXPECT_EQ(summary.largest(), 5.0);
  EXPECT_EQ(summary.time_of_largest(), 1.0);
  EXPECT_EQ(summary.smallest(), -1.0);
  EXPECT_EQ(summary.time_of_smallest(), 3.0);
  EXPECT_DOUBLE_EQ(summary.integral(), 3.0 + 4.0);
  EXPECT_DOUBLE_EQ(summary.rise_integral(), 7.0 - 3.0);
  EXPECT_DOUBLE_EQ(summary.arrival(), 0.75);
}

TEST(ReadingSummary, LeavesOutWhatIsNoNumber) {
  ReadingSummary summary;
  summary.set_rise(1.0);
  summary.add(0.0, nothing);
  EXPECT_FALSE(summary.seen());
  summary.add(1.0, 2.0);
  summary.add(2.0, nothing);
  summary.add(3.0, 4.0);
  EXPECT_TRUE(summary.seen());
  EXPECT_EQ(summary.first(), 2.0);
  EXPECT_EQ(summary.largest(), 4.0);
  EXPECT_EQ(summary.integral(), 0.0);
  EXPECT_EQ(summary.arrival(), 3.0);  // nothing to interpolate from
}

}  // namespace
}  // namespace moraine
