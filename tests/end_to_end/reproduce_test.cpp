// `moraine reproduce`: which runs it keeps, and its table.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "output/manifest.hpp"
#include "output/sha256.hpp"
#include "output/table_csv.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

class Reproduce : public ScratchFolder {
 protected:
  static constexpr std::array names{"surface-charge-4cm", "surface-charge-6cm",
                                    "surface-charge-10cm"};

  /// Results of a case as this program leaves them, with 12 cm of crater and peaks of 9 MPa; at C
  /// nothing was read.
  void leave(std::string const& name, std::string const& revision) const {
    std::filesystem::create_directories(path("runs/" + name));
    Manifest manifest;
    manifest.build = build_info();
    manifest.build.git_revision = revision;
    manifest.end = RunEnd{"end time reached"};
    for (EmbeddedText const& shipped : shipped_cases())
      if (shipped.name == name) manifest.case_sha256 = sha256(std::string(shipped.text));
    write_manifest(path("runs/" + name + "/manifest.json"), manifest);
    TableCsv gauges(path("runs/" + name + "/gauges.csv"), {{"time", "s"},
                                                           {"crater rim_diameter", "m"},
                                                           {"crater depth", "m"},
                                                           {"A pressure", "Pa"},
                                                           {"E pressure", "Pa"}});
    gauges.add(std::array{0.0, 0.0, 0.0, 0.0, 0.0});
    gauges.add(std::array{100e-6, 0.12, 0.12, 9e6, 9e6});
    gauges.add(std::array{500e-6, 0.12, 0.12, 5e6, 5e6});
  }
};

TEST_F(Reproduce, KeepsItsOwnRunsAndLabelsTheirNumbers) {
  for (char const* name : names) leave(name, build_info().git_revision);
  CommandResult const result = moraine_command(
      path(""), {"reproduce", "blast-soil", "--output", "runs", "--csv", "numbers.csv"});
  EXPECT_EQ(result.code, 0) << result.err;
  for (char const* name : names)
    EXPECT_NE(result.out.find("runs/" + std::string(name) + ": there already"), std::string::npos);
  std::string const csv = bytes_of(path("numbers.csv"));
  EXPECT_TRUE(
      csv.starts_with("case,quantity,unit,ours,printed,difference\n"
                      "surface-charge-4cm,\"crater, rim to rim at 200 us\",m,0.12,0.38,-0.684"))
      << csv;
  EXPECT_NE(csv.find("\nsurface-charge-4cm,\"peak at C, 25 cm below\",Pa,,8000000,\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\nsurface-charge-10cm,\"peak at A, 15 cm below\",Pa,9000000,40000000,-0.775"),
            std::string::npos)
      << csv;
}

TEST_F(Reproduce, RunsAgainWhatAnotherProgramLeft) {
  leave(names[0], "another");
  Program program(path(""), {"reproduce", "blast-soil", "--output", "runs", "-t", "1"});
  auto const said = [&] { return bytes_of(path("out")); };
  for (int tries = 0; tries < 600 && said().find("run again") == std::string::npos; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_NE(said().find("runs/surface-charge-4cm: of another case or program, or not at its end; "
                        "run again"),
            std::string::npos)
      << said();
  program.send(SIGKILL);
  program.wait();
}

}  // namespace
}  // namespace moraine
