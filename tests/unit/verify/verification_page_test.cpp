#include "verify/verification_page.hpp"

#include <gtest/gtest.h>

namespace moraine {
namespace {

TEST(VerificationPage, HoldsEveryResultAndCountsThem) {
  std::vector<CheckRun> const runs{
      {"sod",
       "the tube",
       {compare("sod: density", 1.5, 1.0, 1.0, "kg/m^3", "half <of> it"),
        compare("sod: speed", 3.0, 1.0, 1.0, "m/s", "twice"), skip("sod: more", "takes data")},
       2.5},
      {"noh", "the wall", {at_most("noh: drift", 0.25, 1.0, "-", "little")}, 0.5}};
  std::string const page = verification_page(runs, Effort::quick);
  for (char const* const part :
       {"2 pass", "1 fail", "1 skipped", "Quick effort", "half &lt;of&gt; it", "width: 50%",
        "title=\"200 % of the tolerance\"", "id=\"noh\"", "takes data", "(2.5 s)"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "nothing is fetched";
}

TEST(VerificationPage, TellsWhatIsKnownAndWhatIsALimit) {
  std::vector<CheckRun> const runs{
      {"cole",
       "the sphere",
       {explained(compare("cole: peak", 0.75, 1.0, 0.125, "-", "low"), 0.3, "verify/cole"),
        below("cole: order", -0.5, 0.25, "-", "none")},
       1.0}};
  std::string const page = verification_page(runs, Effort::full);
  for (char const* const part :
       {"1 pass", "0 fail", "1 known", "explained in verify/cole, regression bound", "&#8804; 0.25",
        "title=\"200 % of the tolerance\"", "class=\"bar known\""})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace moraine
