#include "report/blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/report/unpacked.hpp"

namespace moraine::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Blocks, GiveBackWhatWasPutIn) {
  Block block("b");
  std::vector<std::uint8_t> const bytes{1, 2, 255};
  std::vector<double> const reals{1.5, -2e300, none};
  std::vector<std::uint16_t> const shorts{0, 65535};
  std::vector<std::uint32_t> const ids{7, 4'000'000'000U};
  auto const a = block.add_u8(bytes);
  auto const b = block.add_f64(reals);  // begins where eight divides the place
  auto const c = block.add_u16(shorts);
  auto const d = block.add_u32(ids);
  auto const e = block.add_f32(std::vector<double>{0.1});
  std::string const raw = unpacked(block.packed());
  EXPECT_EQ(numbers_in<std::uint8_t>(raw, a), bytes);
  auto const read = numbers_in<double>(raw, b);
  EXPECT_EQ(read[0], 1.5);
  EXPECT_EQ(read[1], -2e300);
  EXPECT_TRUE(std::isnan(read[2]));
  EXPECT_EQ(numbers_in<std::uint16_t>(raw, c), shorts);
  EXPECT_EQ(numbers_in<std::uint32_t>(raw, d), ids);
  EXPECT_EQ(numbers_in<float>(raw, e)[0], 0.1F);
  EXPECT_EQ(a.at("block"), "b");
}

TEST(Blocks, WhatIsNotFiniteIsNone) {
  Block block("b");
  auto const wide = block.add_f64(std::vector<double>{infinite, -infinite});
  auto const narrow = block.add_f32(std::vector<double>{1e300});  // beyond a float
  std::string const raw = unpacked(block.packed());
  for (double const value : numbers_in<double>(raw, wide)) EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(std::isnan(numbers_in<float>(raw, narrow)[0]));
}

TEST(Blocks, OfNothingAreWhole) {
  Block const block("empty");
  EXPECT_EQ(unpacked(block.packed()), "");
}

TEST(Blocks, AreDroppedByTheBeginningOfTheirNames) {
  Blocks blocks;
  for (char const* const name : {"run-0/curves", "run-0/frame-0", "run-0/frame-1"})
    blocks.add(Block(name));
  std::size_t const all = blocks.size();
  blocks.drop("run-0/frame-");
  EXPECT_LT(blocks.size(), all);
  EXPECT_EQ(blocks.object().size(), 1u);
  EXPECT_TRUE(blocks.object().contains("run-0/curves"));
}

}  // namespace
}  // namespace moraine::report
