// Files of planes: one per frame, dropped from a frame on, others left alone.
#include "output/plane_recorder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "output/plane_files.hpp"
#include "output/run_folder.hpp"
#include "scratch_folder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr char const* pool = R"(
space = { dimension = 3, domain = { min = [0, 0, 0], max = [0.4, 0.4, 0.8] } }
resolution.spacing = 0.1
time.end = 1
material.water = { eos = "tait" }
[[region]]
name = "pool"
material = "water"
box = { min = [0, 0, 0], max = [0.4, 0.4, 0.4] }
[[gauge]]
name = "cut-1"
kind = "plane"
plane = { min = [0, 0.2, 0], max = [0.4, 0.2, 0.8], step = 0.1 }
)";

class Planes : public ScratchFolder {
 protected:
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (auto const& entry : std::filesystem::directory_iterator(path("planes")))
      names.insert(entry.path().filename().string());
    return names;
  }
};

TEST_F(Planes, AreWrittenDroppedAndGoneOnWith) {
  Case const c = parse_case(pool, "pool.toml");
  Simulation const simulation(build_model(c));
  PlaneRecorder straight(c, path(""));
  for (int frame = 0; frame < 3; ++frame) straight.write(simulation);
  write(path("planes/notes_of_mine.txt"), "other people's");
  std::string const last = bytes_of(path("planes/cut-1_000002.vti"));
  std::string const collection = bytes_of(path("planes/cut-1.pvd"));
  EXPECT_NE(last.find("WholeExtent=\"0 4 0 0 0 8\""), std::string::npos);

  drop_planes(path(""), 1);
  EXPECT_EQ(files(), (std::set<std::string>{"cut-1.pvd", "cut-1_000000.vti", "notes_of_mine.txt"}));
  PlaneRecorder resumed(c, path(""), {0.0});
  resumed.write_collections();
  EXPECT_EQ(bytes_of(path("planes/cut-1.pvd")).find("000001"), std::string::npos);
  for (int frame = 1; frame < 3; ++frame) resumed.write(simulation);
  EXPECT_EQ(bytes_of(path("planes/cut-1_000002.vti")), last);
  EXPECT_EQ(bytes_of(path("planes/cut-1.pvd")), collection);

  make_run_folder(path(""));
  EXPECT_EQ(files(), (std::set<std::string>{"notes_of_mine.txt"}));
}

}  // namespace
}  // namespace moraine
