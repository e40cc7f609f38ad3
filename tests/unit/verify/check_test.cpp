#include "verify/check.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "verify/reference_data.hpp"
#include "verify/report.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

TEST(Check, PassesWithinItsTolerance) {
  EXPECT_TRUE(compare("a", 1.1, 1.0, 0.11, "-", "").pass);
  EXPECT_FALSE(compare("a", 1.1, 1.0, 0.09, "-", "").pass);
  EXPECT_FALSE(compare("a", 0.9, 1.0, 0.09, "-", "").pass);
  EXPECT_FALSE(compare("a", std::nan(""), 1.0, 1e9, "-", "").pass);
  EXPECT_TRUE(at_most("a", -0.1, 0.1, "-", "").pass);
  EXPECT_FALSE(at_most("a", -0.2, 0.1, "-", "").pass);
}

TEST(Check, BelowALimitIsNeverTooLow) {
  EXPECT_TRUE(below("a", 0.25, 0.25, "-", "").pass);
  EXPECT_TRUE(below("a", -7.0, 0.25, "-", "").pass);
  EXPECT_FALSE(below("a", 0.26, 0.25, "-", "").pass);
  EXPECT_FALSE(below("a", std::nan(""), 0.25, "-", "").pass);
}

TEST(Check, WhatIsExplainedIsKnownUpToItsRegressionBound) {
  auto const miss = [](double measured) {
    return explained(compare("a", measured, 1.0, 0.15, "-", ""), 0.27, "verify/a/README.md");
  };
  EXPECT_EQ(miss(0.9).verdict(), Verdict::pass) << "nothing to explain";
  EXPECT_EQ(miss(0.75).verdict(), Verdict::known);
  EXPECT_EQ(miss(1.25).verdict(), Verdict::known);
  EXPECT_FALSE(miss(0.75).failed());
  EXPECT_FALSE(miss(0.75).pass);
  EXPECT_EQ(miss(0.72).verdict(), Verdict::fail) << "worse than it was";
  EXPECT_EQ(miss(std::nan("")).verdict(), Verdict::fail);
  EXPECT_EQ(explained(skip("a", "no data"), 0.27, "page").verdict(), Verdict::skip);
  EXPECT_EQ(compare("a", 0.75, 1.0, 0.15, "-", "").verdict(), Verdict::fail);
}

TEST(Check, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (Check const& check : checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.requirement.empty());
    ASSERT_TRUE(find_check(check.name).has_value());
    EXPECT_EQ(find_check(check.name)->run, check.run);
  }
  EXPECT_GE(names.size(), 7u);
  EXPECT_FALSE(find_check("sod ").has_value());
}

TEST(Check, ChoosesByName) {
  EXPECT_EQ(choose_checks({}).size(), checks().size());
  auto const two = choose_checks({"sod", "energy-order"});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].name, "sod");
  EXPECT_EQ(two[1].name, "energy-order");
}

TEST(Check, UnknownNamesAreReportedTogetherWithWhatWasMeant) {
  try {
    choose_checks({"energy-ordr", "sod", "volcano"});
    FAIL() << "no error";
  } catch (InputErrors const& errors) {
    ASSERT_EQ(errors.problems().size(), 2u);
    EXPECT_NE(std::string(errors.what()).find("did you mean \"energy-order\"?"), std::string::npos);
    EXPECT_NE(std::string(errors.what()).find("volcano"), std::string::npos);
  }
}

TEST(Check, WhatThrowsDoesNotPass) {
  Check const broken{"broken", "", [](Effort) -> std::vector<CheckResult> {
                       throw std::runtime_error("pipe burst");
                     }};
  auto const results = run_check(broken, Effort::quick);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_FALSE(results[0].pass);
  EXPECT_EQ(results[0].name, "broken");
  EXPECT_EQ(results[0].note, "pipe burst");
}

TEST(Check, WhatIsSkippedNeitherPassesNorFails) {
  CheckResult const result = skip("a", "no data");
  EXPECT_FALSE(result.pass);
  EXPECT_FALSE(result.failed());
  EXPECT_TRUE(std::isnan(result.measured));
  EXPECT_TRUE(compare("a", 2.0, 1.0, 0.1, "-", "").failed());
  EXPECT_FALSE(compare("a", 1.0, 1.0, 0.1, "-", "").failed());
}

// One fast check of the suite, so that a registry of wrong functions would show.
TEST(Check, MomentumRuns) {
  auto const results = run_check(*find_check("momentum-double"), Effort::quick);
  ASSERT_EQ(results.size(), 4u);
  for (CheckResult const& result : results) {
    EXPECT_TRUE(result.pass) << result.name << " " << result.measured;
    EXPECT_EQ(result.name.substr(0, 15), "momentum-double");
  }
}

TEST(Report, JsonHasOneObjectPerResult) {
  std::vector<CheckResult> const results{
      compare("a", 1.5, 2.0, 1.0, "Pa", "note"),
      compare("b", std::numeric_limits<double>::quiet_NaN(), 2.0, 1.0, "-", "")};
  auto const json = nlohmann::ordered_json::parse(to_json(results).dump());
  ASSERT_TRUE(json.is_array());
  ASSERT_EQ(json.size(), 2u);
  for (auto const& object : json)
    for (char const* const key :
         {"name", "measured", "reference", "tolerance", "unit", "pass", "skipped", "known",
          "from_below", "worst", "explained_in", "note"})
      EXPECT_TRUE(object.contains(key)) << key;
  EXPECT_EQ(json[0]["name"], "a");
  EXPECT_EQ(json[0]["measured"], 1.5);
  EXPECT_EQ(json[0]["unit"], "Pa");
  EXPECT_EQ(json[0]["pass"], true);
  EXPECT_TRUE(json[1]["measured"].is_null());
  EXPECT_EQ(json[1]["pass"], false);
}

TEST(Report, TableAndSummaryNameWhatFails) {
  std::vector<CheckResult> const results{compare("good", 1.0, 1.0, 0.1, "Pa", ""),
                                         compare("bad", 2.0, 1.0, 0.1, "Pa", "too high")};
  std::string const plain = results_table(results, Colour::none);
  EXPECT_NE(plain.find("pass  good"), std::string::npos);
  EXPECT_NE(plain.find("FAIL  bad "), std::string::npos);
  EXPECT_NE(plain.find("too high"), std::string::npos);
  EXPECT_EQ(plain.find('\033'), std::string::npos);
  EXPECT_NE(results_table(results, Colour::terminal).find("\033[31mFAIL"), std::string::npos);
  EXPECT_EQ(summary(results), "1 of 2 results pass; not: bad");
}

TEST(Report, TableAndSummaryNameWhatWasSkipped) {
  std::vector<CheckResult> const results{compare("good", 1.0, 1.0, 0.1, "Pa", ""),
                                         skip("absent", "no data here")};
  EXPECT_NE(results_table(results, Colour::none).find("skip  absent  no data here\n"),
            std::string::npos);
  EXPECT_NE(results_table(results, Colour::terminal).find("\033[33mskip"), std::string::npos);
  EXPECT_EQ(summary(results), "1 of 1 results pass; skipped: absent");
  EXPECT_EQ(to_json(results)[1]["skipped"], true);
}

TEST(Report, TableAndSummaryNameWhatIsKnown) {
  std::vector<CheckResult> const results{
      compare("good", 1.0, 1.0, 0.1, "Pa", ""),
      explained(compare("low", 0.7, 1.0, 0.1, "Pa", "peak"), 0.4, "verify/low/README.md")};
  std::string const plain = results_table(results, Colour::none);
  EXPECT_NE(plain.find("known low "), std::string::npos);
  EXPECT_NE(plain.find("peak; explained in verify/low/README.md, regression bound +- 0.4\n"),
            std::string::npos);
  EXPECT_EQ(summary(results), "1 of 2 results pass; 1 known and explained: low");
  auto const json = to_json(results);
  EXPECT_EQ(json[0]["known"], false);
  EXPECT_TRUE(json[0]["worst"].is_null());
  EXPECT_EQ(json[1]["known"], true);
  EXPECT_EQ(json[1]["pass"], false);
  EXPECT_EQ(json[1]["worst"], 0.4);
}

TEST(Report, TableTellsALimitFromAReference) {
  std::vector<CheckResult> const results{below("order", -0.3, 0.25, "-", "none")};
  std::string const plain = results_table(results, Colour::none);
  EXPECT_NE(plain.find("pass  order"), std::string::npos);
  EXPECT_NE(plain.find("at most        0.25"), std::string::npos);
  EXPECT_EQ(plain.find("+-"), std::string::npos);
}

TEST(ReferenceData, IsWhereTheEnvironmentSaysOrBesideTheFolder) {
  auto const root =
      std::filesystem::temp_directory_path() / ("moraine_reference_" + std::to_string(getpid()));
  std::filesystem::create_directories(root / "shared" / "data" / "sub");
  std::ofstream(root / "shared" / "data" / "sub" / "a.csv") << "a\n";
  char const* const told = std::getenv("MORAINE_REFERENCE_DATA");
  std::string const before = told == nullptr ? "" : told;
  unsetenv("MORAINE_REFERENCE_DATA");
  EXPECT_EQ(reference_file("sub/a.csv", root / "sources"), root / "shared" / "data" / "sub/a.csv");
  EXPECT_TRUE(reference_file("sub/b.csv", root / "sources").empty());
  setenv("MORAINE_REFERENCE_DATA", (root / "shared").c_str(), 1);
  EXPECT_TRUE(reference_file("sub/a.csv", root / "sources").empty());
  EXPECT_EQ(reference_file("data/sub/a.csv", root / "x"), root / "shared" / "data/sub/a.csv");
  if (told != nullptr)
    setenv("MORAINE_REFERENCE_DATA", before.c_str(), 1);
  else
    unsetenv("MORAINE_REFERENCE_DATA");
  std::filesystem::remove_all(root);
}

TEST(ShippedCases, AllReadAndOneIsNotThere) {
  std::set<std::string_view> names;
  for (EmbeddedText const& shipped : shipped_cases()) {
    names.insert(shipped.name);
    EXPECT_NO_THROW(shipped_case(shipped.name)) << shipped.name;
  }
  for (char const* const name :
       {"dam-break-2d", "dam-break-3d", "hydrostatic-tank", "sod", "tnt-in-water"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_THROW(shipped_case("volcano"), std::invalid_argument);
}

}  // namespace
}  // namespace moraine
