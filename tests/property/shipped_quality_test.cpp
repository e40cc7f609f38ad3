// What reports say of shipped cases: whatever planes, periodic sides or walls a case has, its
// verdicts on energy and momentum must be true.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "output/run_folder.hpp"
#include "output/run_recorder.hpp"
#include "output/run_status.hpp"
#include "report/quality.hpp"
#include "report/run_files.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "support/places.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class ShippedQuality : public ScratchFolder, public testing::WithParamInterface<std::string> {};

std::string value_of(report::Json const& rows, std::string const& name, char const* member) {
  for (auto const& row : rows)
    if (row.at("name") == name) return row.at(member);
  return "no row " + name;
}

/// Rows of the quality table after some steps.
report::Json quality_after(int steps, std::string const& name,
                           std::filesystem::path const& folder) {
  Case c = read_case(source_folder() + "/cases/" + name + "/case.toml");
  Simulation simulation(build_model(c));
  make_run_folder(folder);
  RunRecorder recorder(c, simulation, folder, 1);
  for (int step = 0; step < steps; ++step) {
    simulation.advance();
    recorder.tell(simulation);
  }
  recorder.finish(simulation, "enough", 0.0);
  write_status(folder / "status.json", simulation, {});
  return report::quality_of(report::read_run_files(folder));
}

TEST_P(ShippedQuality, IsNotBad) {
  auto const rows = quality_after(100, GetParam(), path("run"));
  for (char const* const name : {"energy that nobody booked", "momentum that nobody gave"})
    EXPECT_NE(value_of(rows, name, "verdict"), "bad")
        << name << ": " << value_of(rows, name, "value");
}

INSTANTIATE_TEST_SUITE_P(, ShippedQuality,
                         testing::Values("couette", "dam-break-2d", "hydrostatic-tank", "noh",
                                         "poiseuille", "sloshing-tank", "sod", "standing-wave",
                                         "surface-charge-6cm", "taylor-green", "tnt-in-water",
                                         "tnt-slab", "toro"),
                         [](auto const& shipped) {
                           std::string name = shipped.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

class BlindGuards : public ScratchFolder {};

// Guards that cannot see what they look for do not say that all is well.
TEST_F(BlindGuards, SayWhereTheyDoNotLook) {
  auto const rows = quality_after(2, "poiseuille", path("run"));
  EXPECT_EQ(value_of(rows, "guard: budget", "verdict"), "unknown");
  EXPECT_EQ(value_of(rows, "energy that nobody booked", "verdict"), "unknown");
  EXPECT_EQ(value_of(rows, "guard: speed", "verdict"), "good");
}

}  // namespace
}  // namespace moraine
