#include "sweep/case_key.hpp"

#include <gtest/gtest.h>

#include "setup/read_case.hpp"
#include "unit/sweep/sample_case.hpp"

namespace moraine {
namespace {

class CaseKeys : public ::testing::Test {
 protected:
  CaseKey key(std::string const& path) const {
    auto const found = find_key(path, case_);
    if (auto const* mistake = std::get_if<KeyMistake>(&found)) {
      ADD_FAILURE() << path << ' ' << mistake->rule << "; " << mistake->hint;
      return {};
    }
    return std::get<CaseKey>(found);
  }
  std::string mistake(std::string const& path) const {
    auto const found = find_key(path, case_);
    auto const* mistake = std::get_if<KeyMistake>(&found);
    return mistake == nullptr ? "" : mistake->rule + "; " + mistake->hint;
  }
  Case const case_ = parse_case(sample_case, "sample.toml");
};

TEST_F(CaseKeys, AreFoundByTheirPaths) {
  CaseKey const spacing = key("resolution.spacing");
  EXPECT_EQ(spacing.section, Section::top);
  EXPECT_EQ(spacing.inner, "resolution.spacing");
  EXPECT_EQ(spacing.parameter->quantity, Quantity::length);
  CaseKey const radius = key("region.bubble.disc.radius");
  EXPECT_EQ(radius.section, Section::region);
  EXPECT_EQ(radius.item, "bubble");
  EXPECT_EQ(radius.inner, "disc.radius");
  EXPECT_EQ(key("material.gas.heat_capacity_ratio").item, "gas");
  EXPECT_EQ(key("wall.tank.method").inner, "method");
}

TEST_F(CaseKeys, TakeTheLongestNameThatFits) {
  EXPECT_EQ(key("gauge.1.5 cm.position").item, "1.5 cm");
  EXPECT_EQ(key("gauge.1.position").item, "1");
}

TEST_F(CaseKeys, AreThoseOfTheChoiceThatTheCaseMade) {
  EXPECT_EQ(key("material.water.reference_density").parameter->when_value, "tait");
  EXPECT_EQ(key("material.gas.reference_density").parameter->when_value, "ideal_gas");
}

TEST_F(CaseKeys, WhatIsNoneIsTold) {
  EXPECT_EQ(mistake("resolution.spacin"),
            "is no key of a case; did you mean \"resolution.spacing\"?");
  EXPECT_EQ(mistake("material.gas.density"),
            "is no key of a case; did you mean \"material.gas.reference_density\"?");
  EXPECT_EQ(mistake("region.buble.disc.radius"),
            "names no region of the case; did you mean \"bubble\"?");
  EXPECT_EQ(mistake("stage.blast.detonate"), "names no stage of the case; the case has no stage");
  EXPECT_EQ(mistake("region"), "is a table; name a key in it: \"region.NAME.KEY\"");
  EXPECT_EQ(mistake("region.bubble.name"), "is a name, which a sweep cannot change; ");
  EXPECT_EQ(mistake("resolution").substr(0, 10), "is a table");
  EXPECT_EQ(mistake("xyz"), "is no key of a case; moraine explain lists all keys");
}

}  // namespace
}  // namespace moraine
