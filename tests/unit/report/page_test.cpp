#include "report/page.hpp"

#include <gtest/gtest.h>

#include "unit/report/unpacked.hpp"

namespace moraine::report {
namespace {

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Page, HoldsDataAndNothingOfTheMarks) {
  Json report = empty_report();
  report["runs"].push_back({{"title", "a run"}});
  std::string const page = page_of("A run", report, Blocks(), true);
  EXPECT_EQ(page.find("@@DATA@@"), std::string::npos);
  EXPECT_EQ(page.find("@@PLAYER@@"), std::string::npos);
  EXPECT_NE(page.find("<title>\nA run\n</title>"), std::string::npos);
  EXPECT_EQ(PageReader(page).run().at("title"), "a run");
  EXPECT_LT(page_of("A run", report, Blocks(), false).size(), page.size());
}

// Texts of a case can neither end the script that they stand in nor begin another.
TEST(Page, TextsStayTexts) {
  std::string const hostile = "</script><script>alert(1)</script><!-- @@PLAYER@@ & \"x\" \xff";
  Json report = empty_report();
  report["runs"].push_back({{"title", hostile}});
  std::string const plain = page_of("t", empty_report(), Blocks(), false);
  std::string const page = page_of(hostile, report, Blocks(), false);
  EXPECT_EQ(count(page, "<script"), count(plain, "<script"));
  EXPECT_EQ(count(page, "</script>"), count(plain, "</script>"));
  EXPECT_EQ(page.find("<!-- @@"), std::string::npos);
  std::string const title = PageReader(page).run().at("title");
  EXPECT_EQ(title.substr(0, 40), hostile.substr(0, 40)) << "and reads as it was";
}

TEST(Page, SaysHowToCite) {
  auto const cite = empty_report().at("cite");
  EXPECT_NE(cite.at("text").get<std::string>().find("The Moraine authors"), std::string::npos);
  EXPECT_EQ(count(cite.at("bibtex"), "{"), count(cite.at("bibtex"), "}"));
}

}  // namespace
}  // namespace moraine::report
