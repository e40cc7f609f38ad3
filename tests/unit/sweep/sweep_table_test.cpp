#include "sweep/sweep_table.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class SweepTables : public ScratchFolder {
 protected:
  static SweepTable table() {
    SweepTable table{"two members",
                     {{"spacing", "m"}, {"kernel, used", ""}},
                     {{"peak", "Pa"}, {"arrival", "s"}},
                     {}};
    table.members.push_back({"001-a",
                             SweepTable::State::done,
                             "",
                             std::nullopt,
                             {0.01, std::string("cubic_spline")},
                             {1.5e9, std::nullopt}});
    table.members.push_back({"002-b",
                             SweepTable::State::failed,
                             "said \"no\", twice",
                             std::nullopt,
                             {0.1, std::string("lucy")},
                             {std::nullopt, std::nullopt}});
    return table;
  }
  std::vector<MemberCost> const costs_{{120.0, 0.25}, {}};
};

TEST_F(SweepTables, AsCsvHaveOneRowForEachMember) {
  write_sweep_csv(table(), costs_, path("sweep.csv"));
  EXPECT_EQ(bytes_of(path("sweep.csv")),
            "member,state,spacing [m],\"kernel, used\",peak [Pa],arrival [s],steps,wall_time [s],"
            "message\n"
            "001-a,done,0.01,cubic_spline,1500000000,,120,0.25,\n"
            "002-b,failed,0.1,lucy,,,,,\"said \"\"no\"\", twice\"\n");
}

// The names are those of the type Sweep in report/FORMAT.md.
TEST_F(SweepTables, AsJsonAreTheSweepOfAReport) {
  write_sweep_json(table(), costs_, path("sweep.json"));
  auto const json = nlohmann::json::parse(bytes_of(path("sweep.json")));
  EXPECT_EQ(json.at("title"), "two members");
  EXPECT_EQ(json.at("parameters").at(0), (nlohmann::json{{"label", "spacing"}, {"unit", "m"}}));
  auto const& first = json.at("members").at(0);
  EXPECT_EQ(first.at("state"), "done");
  EXPECT_EQ(first.at("values"), nlohmann::json::array({0.01, "cubic_spline"}));
  EXPECT_TRUE(first.at("run").is_null());
  EXPECT_TRUE(first.at("outputs").at(1).is_null());
  EXPECT_EQ(json.at("members").at(1).at("message"), "said \"no\", twice");
}

TEST_F(SweepTables, AreReadAsTheyWereWritten) {
  SweepTable const written = table();
  write_sweep_json(written, costs_, path("sweep.json"));
  SweepTable const read = read_sweep_table(path(""));
  EXPECT_EQ(read.title, written.title);
  EXPECT_EQ(read.parameters[1].label, "kernel, used");
  EXPECT_EQ(read.outputs[0].unit, "Pa");
  ASSERT_EQ(read.members.size(), 2U);
  EXPECT_EQ(read.members[0].values, written.members[0].values);
  EXPECT_EQ(read.members[0].outputs, written.members[0].outputs);
  EXPECT_EQ(read.members[1].state, SweepTable::State::failed);
  EXPECT_EQ(member_folders(read, "out/x")[1], "out/x/members/002-b");
}

TEST_F(SweepTables, InfinityIsATextInJson) {
  SweepTable infinite = table();
  infinite.members[0].values[0] = std::numeric_limits<double>::infinity();
  write_sweep_json(infinite, costs_, path("sweep.json"));
  EXPECT_EQ(std::get<std::string>(read_sweep_table(path("")).members[0].values[0]), "inf");
}

TEST_F(SweepTables, DamagedOnesAreRefused) {
  EXPECT_THROW(read_sweep_table(path("")), std::runtime_error);
  for (char const* text : {"", "[]", "{\"title\": 3}", "{\"title\": \"t\", \"parameters\": []}"}) {
    write(path("sweep.json"), text);
    EXPECT_THROW(read_sweep_table(path("")), std::runtime_error) << text;
  }
}

}  // namespace
}  // namespace moraine
