#include "base/input_error.hpp"

#include <gtest/gtest.h>

#include <array>

namespace moraine {
namespace {

TEST(InputError, FormatsOneLine) {
  InputProblem problem{"case.toml",          12, 9, "material.tnt.density", "\"3 kg\"", "is a mass",
                       "did you mean \"x\"?"};
  EXPECT_EQ(format(problem),
            "case.toml:12:9: material.tnt.density: \"3 kg\" is a mass; did you mean \"x\"?");
  problem.line = 0;
  problem.value.clear();
  problem.hint.clear();
  EXPECT_EQ(format(problem), "case.toml: material.tnt.density: is a mass");
}

TEST(InputError, ListsAllInTheOrderOfTheFile) {
  InputErrors const errors({{"f", 3, 1, "b", "", "two", ""},
                            {"f", 1, 5, "a", "", "one", ""},
                            {"f", 3, 1, "c", "", "three", ""}});
  EXPECT_STREQ(errors.what(), "f:1:5: a: one\nf:3:1: b: two\nf:3:1: c: three");
  ASSERT_EQ(errors.problems().size(), 3U);
  EXPECT_EQ(errors.problems()[0].key, "a");
}

TEST(InputError, EditDistance) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("spacing", "spaicng"), 1U);  // two neighbours swapped
}

TEST(InputError, NearestName) {
  constexpr std::array<std::string_view, 4> names{"cubic_spline", "wendland_c2", "x", "y"};
  EXPECT_EQ(nearest_name("wendland_c4", names), "wendland_c2");
  EXPECT_EQ(nearest_name("wendland", names), "wendland_c2");
  EXPECT_EQ(nearest_name("cubic", names), "cubic_spline");
  EXPECT_EQ(nearest_name("spline", names), "cubic_spline");
  EXPECT_EQ(nearest_name("gaussian", names), "");
  EXPECT_EQ(nearest_name("z", names), "");  // one letter resembles nothing
  EXPECT_EQ(name_hint("z", std::array<std::string_view, 2>{"x", "y"}),
            "choose one of \"x\", \"y\"");
}

}  // namespace
}  // namespace moraine
