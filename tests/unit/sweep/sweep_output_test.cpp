#include "sweep/sweep_output.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class SweepOutputs : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("gauges.json"), R"({"gauges": [{"name": "a", "seen": true, "columns": {
      "a pressure": {"unit": "Pa", "first": 0.0, "largest": 5.0, "time_of_largest": 0.2,
        "smallest": -1.0, "time_of_smallest": 0.3, "integral_over_time": 0.7, "impulse": 0.6,
        "arrival": null}}}]})");
    write(path("gauges.csv"), "time [s],a pressure [Pa]\n0,0\n0.2,5\n0.3,-1\n0.4,nan\n");
    write(path("sums.csv"),
          "time [s],kinetic_energy [J],internal_energy [J],potential_energy [J],total_energy [J],"
          "lost_energy [J],wall_work [J],damping_work [J],detonation_energy [J],drift_work [J]\n"
          "0,0,10,4,14,0,0,0,0,0\n1,6,5,3,14,0,0,0,0,0\n2,8,2,2,12,3,5,-3,1,0\n");
    write(path("manifest.json"), R"({"state": "ended", "end": {"reason": "end time reached",
      "wall_time_s": 1.5, "simulated_time_s": 0.4, "steps": 40, "particles": 9}})");
  }
  double gauge(Measure measure) const {
    SweepOutput output;
    output.gauge = "a";
    output.column = "a pressure";
    output.measure = measure;
    return read_outputs({output}, path("")).front();
  }
  double sums(std::string const& column, Measure measure) const {
    SweepOutput output;
    output.from = OutputSource::sums;
    output.column = column;
    output.measure = measure;
    return read_outputs({output}, path("")).front();
  }
  double run(RunNumber number) const {
    SweepOutput output;
    output.from = OutputSource::run;
    output.number = number;
    return read_outputs({output}, path("")).front();
  }
};

TEST_F(SweepOutputs, OfGauges) {
  EXPECT_EQ(gauge(Measure::largest), 5.0);
  EXPECT_EQ(gauge(Measure::time_of_largest), 0.2);
  EXPECT_EQ(gauge(Measure::smallest), -1.0);
  EXPECT_EQ(gauge(Measure::time_of_smallest), 0.3);
  EXPECT_EQ(gauge(Measure::integral), 0.7);
  EXPECT_EQ(gauge(Measure::impulse), 0.6);
  EXPECT_EQ(gauge(Measure::last), -1.0) << "the last reading that is a number";
  EXPECT_TRUE(std::isnan(gauge(Measure::arrival))) << "nothing arrived";
}

TEST_F(SweepOutputs, OfSumsAndRuns) {
  EXPECT_EQ(sums("kinetic_energy", Measure::largest), 8.0);
  EXPECT_EQ(sums("internal_energy", Measure::smallest), 2.0);
  EXPECT_EQ(sums("total_energy", Measure::last), 12.0);
  EXPECT_EQ(sums("kinetic_energy", Measure::integral), 10.0);
  EXPECT_EQ(run(RunNumber::wall_time), 1.5);
  EXPECT_EQ(run(RunNumber::steps), 40.0);
  EXPECT_EQ(run(RunNumber::particles), 9.0);
  // 12 J are left and 3 J lost of 14 J; 5 J of walls and 1 J of a charge came, damping took 3 J.
  EXPECT_EQ(run(RunNumber::energy_error), 0.25) << "2 J of 8 J that were exchanged";
}

TEST_F(SweepOutputs, OfAFolderWithoutFilesAreAnError) {
  std::filesystem::remove(path("gauges.json"));
  EXPECT_THROW(gauge(Measure::largest), std::runtime_error);
  EXPECT_THROW(sums("no_such_sum", Measure::largest), std::runtime_error);
}

}  // namespace
}  // namespace moraine
