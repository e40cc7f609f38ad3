// Text, JSON, tables and pictures of answers.
#include <gtest/gtest.h>

#include <cmath>

#include "output/blast/answer_json.hpp"
#include "output/blast/answer_text.hpp"
#include "output/blast/facts.hpp"
#include "output/blast/series.hpp"
#include "output/table_csv.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine::blast {
namespace {

Situation charge(double mass, double distance) {
  Situation s;
  s.charge_mass = mass;
  s.distance = distance;
  return s;
}

TEST(BlastNumbers, AreReadable) {
  EXPECT_EQ(readable(0.0), "0");
  EXPECT_EQ(readable(1.0), "1.000");
  EXPECT_EQ(readable(12.3456), "12.35");
  EXPECT_EQ(readable(-0.0123456), "-0.01235");
  EXPECT_EQ(readable(0.123456), "0.1235");
  EXPECT_EQ(readable(123456.0), "123500");
  EXPECT_EQ(readable(1234567.0), "1.235e+06");
  EXPECT_EQ(readable(0.00012345), "1.234e-04");
  EXPECT_EQ(readable(unknown), "none");
  EXPECT_EQ(with_unit("peak_overpressure", "kPa"), "peak overpressure (kPa)");
  EXPECT_EQ(with_unit("energy_lost", "1"), "energy lost");
}

TEST(BlastUnits, OfSystemsAndOfTheirOwn) {
  OutputUnits units;
  EXPECT_EQ(units.unit(Measure::peak_overpressure), "kPa");
  EXPECT_DOUBLE_EQ(units.shown(Measure::peak_overpressure, 2500.0), 2.5);
  units.system = UnitSystem::imperial;
  EXPECT_NEAR(units.shown(Measure::peak_overpressure, psi), 1.0, 1e-12);
  units.chosen[static_cast<std::size_t>(Kind::pressure)] = "bar";
  EXPECT_DOUBLE_EQ(units.shown(Measure::reflected_overpressure, 2e5), 2.0);
  EXPECT_EQ(units.unit(Measure::crater_diameter), "ft");
}

TEST(BlastText, ShowsValuesStandingAndWarnings) {
  std::string const text = answer_text(answer(Topic::air, charge(10.0, 5.0)), {});
  EXPECT_NE(text.find("peak overpressure (kPa)\n  kingery_bulmash           140.3  "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("doubtful [1] [2]\n"), std::string::npos);
  EXPECT_NE(text.find("\nwarnings\n  [1] its source states no range\n"), std::string::npos);
  EXPECT_NE(text.find("spread of 5"), std::string::npos);
  std::string const near = answer_text(answer(Topic::air, charge(10.0, 0.01)), {});
  EXPECT_EQ(near.find("recommended"), std::string::npos) << "nothing is, outside its range\n"
                                                         << near;
  EXPECT_EQ(near.find("spread"), std::string::npos);
}

TEST(BlastText, ListsAllRelations) {
  std::string const text = list_text(relations());
  for (Relation const& relation : relations()) {
    EXPECT_NE(text.find(relation.formula), std::string::npos) << relation.name;
    EXPECT_NE(text.find(relation.source), std::string::npos) << relation.name;
  }
  EXPECT_EQ(to_json(relations()).size(), relations().size());
}

TEST(BlastFacts, NameTheFieldsVariables) {
  auto const lines = facts(Topic::air, charge(10.0, 5.0), UnitSystem::metric);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1], "R/W^(1/3) is 2.321 m/kg^(1/3) or 5.850 ft/lb^(1/3)");
}

TEST(BlastJson, HoldsNumbersAndNulls) {
  OutputUnits units;
  units.system = UnitSystem::si;
  Situation s;
  s.overpressure = 2e5;
  s.angle = 1.0;
  auto const json = to_json(answer(Topic::reflection, s), units);
  auto const& first = json.at("estimates").at(0);
  EXPECT_EQ(first.at("relation"), "two_shock");
  EXPECT_TRUE(first.at("value").is_null());
  EXPECT_EQ(first.at("in_range"), false);
  EXPECT_EQ(first.at("unit"), "Pa");
  EXPECT_EQ(first.at("warnings").size(), 1u);
  EXPECT_NEAR(first.at("range").at("at").get<double>(), 2e5 / 101325.0, 1e-12);
  EXPECT_EQ(json.at("spreads").size(), 0u);
}

Series along(std::vector<double> points) {
  Series series{"distance", "m", true, std::move(points), {}};
  for (double const r : series.points)
    series.answers.push_back(answer(Topic::air, charge(10.0, r)));
  return series;
}

class BlastSeries : public ScratchFolder {};

TEST_F(BlastSeries, TableSaysWhatNumbersAreWorth) {
  OutputUnits units;
  Series const series = along({0.1, 5.0, 30.0});
  write_csv(path("a.csv"), series, units);
  Table const table = read_table_csv(path("a.csv"));
  ASSERT_EQ(table.rows(), 3u);
  auto const column = [&](char const* name) { return *table.find(name); };
  EXPECT_EQ(column("distance"), series.points);
  auto const kingery = column("peak overpressure kingery_bulmash status");
  EXPECT_EQ(kingery, (std::vector<double>{2.0, 0.0, 0.0}));
  EXPECT_EQ(column("peak overpressure tnt_block_1_lb status"), std::vector<double>(3, 3.0));
  EXPECT_EQ(column("peak overpressure three_term_fit status"),
            (std::vector<double>{2.0, 0.0, 2.0}));
  EXPECT_NEAR(column("peak overpressure kingery_bulmash")[1], 140.3, 0.05);
  EXPECT_EQ(table.columns[1].unit, "kPa");
  EXPECT_EQ(table.columns.size(), 1 + 2 * series.answers[0].estimates.size());
}

TEST_F(BlastSeries, TextMarksWhatNeedsCare) {
  std::string const text = series_text(along({0.1, 5.0}), {});
  EXPECT_NE(text.find("peak overpressure (kPa)\ndistance (m)"), std::string::npos) << text;
  EXPECT_NE(text.find("140.3  "), std::string::npos);
  EXPECT_NE(text.find("1110!!"), std::string::npos) << text;
  EXPECT_EQ(text.find("140.3!"), std::string::npos);
}

TEST_F(BlastSeries, PictureIsDrawn) {
  std::vector<double> points;
  for (int i = 0; i < 30; ++i) points.push_back(0.5 * std::pow(1.2, i));
  for (auto const* file : {"a.svg", "a.png"}) {
    draw_series(path(file), "free air", along(points), {});
    EXPECT_GT(std::filesystem::file_size(path(file)), 10000u);
  }
  EXPECT_THROW(draw_series(path("a.pdf"), "", along(points), {}), std::invalid_argument);
}

}  // namespace
}  // namespace moraine::blast
