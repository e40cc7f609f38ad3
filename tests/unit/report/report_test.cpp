#include "report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "output/pvd_collection.hpp"
#include "output/run_folder.hpp"
#include "output/run_recorder.hpp"
#include "output/run_status.hpp"
#include "output/vtp_writer.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "unit/output/scratch_folder.hpp"
#include "unit/report/unpacked.hpp"

namespace moraine::report {
namespace {

/// A tank with a pulse of pressure, hostile names, references, and a gauge out of reach.
constexpr char const* small_tank = R"(title = "tank </script><b>"
space = { dimension = 2, domain = { min = [-1.0, -1.0], max = [2.0, 2.0] } }
resolution.spacing = 0.1
time = { end = 0.02, fixed_step = 0.001 }
output = { frames = 0.002, arrival_pressure = 1.0 }
material.water = { eos = "tait", reference_sound_speed = 10.0 }
[[region]]
name = "water"
material = "water"
box = { min = [0.0, 0.0], max = [1.0, 1.0] }
velocity = [1.0, 0.0]
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [1.0, 1.0] }
[[gauge]]
name = "a <i>gauge</i>"
position = [0.9, 0.5]
[[gauge]]
name = "nowhere"
position = [1.9, 1.9]
[[reference]]
name = "not this"
gauge = "a <i>gauge</i>"
value = 1e9
tolerance = 0.1
source = "made up"
[[reference]]
name = "anything"
gauge = "a <i>gauge</i>"
column = "density"
measure = "last"
value = 1000
tolerance = 0.5
source = "made up"
[[reference]]
name = "a line"
gauge = "a <i>gauge</i>"
file = "line.csv"
source = "drawn by hand"
)";

class RunReport : public ScratchFolder {
 protected:
  /// Runs the case to its end in the folder `name`.
  void run(std::string const& name, std::string const& text = small_tank) {
    write(path("line.csv"), "time [s],pressure [Pa]\n0,0\n0.01,100\n");
    write(path("case.toml"), text);
    Case const c = read_case(path("case.toml"));
    Simulation simulation(build_model(c));
    make_run_folder(path(name));
    RunRecorder recorder(c, simulation, path(name), 1);
    while (simulation.running()) {
      simulation.advance();
      recorder.tell(simulation);
    }
    recorder.finish(simulation, "end time reached", 1.0);
    RunStatus status;
    status.phase = RunPhase::ended;
    status.reason = "end time reached";
    status.votes = recorder.votes().shares();
    write_status(path(name) / "status.json", simulation, status);
  }
  PageReader report(std::vector<std::string> const& names, ReportOptions options = {}) {
    std::vector<std::filesystem::path> folders;
    for (auto const& name : names) folders.push_back(path(name));
    options.file = path("report.html");
    write_report(folders, options);
    return PageReader(bytes_of(options.file));
  }
  static nlohmann::ordered_json row(nlohmann::ordered_json const& rows, std::string const& name) {
    for (auto const& each : rows)
      if (each.at("name") == name) return each;
    ADD_FAILURE() << "no row " << name;
    return {};
  }
};

TEST_F(RunReport, HoldsReadingsAsTheyWereWritten) {
  run("one");
  PageReader const page = report({"one"});
  Table const table = read_table_csv(path("one/gauges.csv"));
  auto const shown = page.gauge("a <i>gauge</i> pressure");
  auto const* const written = table.find("a <i>gauge</i> pressure");
  ASSERT_NE(written, nullptr);
  ASSERT_EQ(shown.size(), written->size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    EXPECT_EQ(shown[i], static_cast<float>((*written)[i])) << i;
  EXPECT_EQ(page.run().at("title"), "tank </script><b>");
  EXPECT_EQ(page.run().at("state"), "ended");
}

TEST_F(RunReport, JudgesTheRun) {
  run("one");
  PageReader const page = report({"one"});
  auto const& quality = page.run().at("quality");
  EXPECT_EQ(row(quality, "end").at("verdict"), "good");
  EXPECT_EQ(row(quality, "energy that nobody booked").at("verdict"), "good");
  EXPECT_EQ(row(quality, "momentum that nobody gave").at("verdict"), "good");
  EXPECT_EQ(row(quality, "particles that left the domain").at("value"), "none");
  EXPECT_EQ(row(quality, "gauges").at("verdict"), "doubtful");
  EXPECT_NE(row(quality, "gauges").at("value").get<std::string>().find("nowhere"),
            std::string::npos);
  double share = 0.0;
  for (auto const& vote : page.run().at("votes")) share += vote.at("share").get<double>();
  EXPECT_NEAR(share, 1.0, 1e-12);
}

TEST_F(RunReport, ComparesWithTheReferencesOfTheCase) {
  run("one");
  PageReader const page = report({"one"});
  auto const& comparisons = page.run().at("comparisons");
  EXPECT_EQ(row(comparisons, "not this").at("verdict"), "bad");
  EXPECT_EQ(row(comparisons, "not this").at("tolerance"), 1e8);
  auto const density = row(comparisons, "anything");
  EXPECT_EQ(density.at("verdict"), "good");
  EXPECT_EQ(density.at("unit"), "kg/m^3");
  Table const table = read_table_csv(path("one/gauges.csv"));
  EXPECT_EQ(density.at("value"), table.find("a <i>gauge</i> density")->back());
  auto const& curve = page.run().at("references").at(0);
  EXPECT_EQ(curve.at("column"), "a <i>gauge</i> pressure");
  EXPECT_EQ(page.numbers<double>(curve.at("value")), (std::vector<double>{0.0, 100.0}));
}

TEST_F(RunReport, ShowsParticlesWhereTheyWere) {
  run("one");
  PageReader const page = report({"one"});
  auto const& particles = page.run().at("particles");
  EXPECT_EQ(particles.at("total"), 100);
  EXPECT_EQ(particles.at("note"), "");
  EXPECT_EQ(particles.at("materials"), nlohmann::ordered_json::array({"water"}));
  EXPECT_EQ(particles.at("frames").size(), read_pvd(path("one/particles.pvd")).size());
  auto const& first = particles.at("frames").at(0);
  auto const ids = page.numbers<std::uint32_t>(first.at("id"));
  auto const x = page.numbers<std::uint16_t>(first.at("position").at(0));
  ASSERT_EQ(x.size(), 100u);
  double const low = particles.at("box").at("min").at(0),
               high = particles.at("box").at("max").at(0);
  // The lattice, ten to a row, to half a step of the box.
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const place = low + x[i] / 65534.0 * (high - low);
    double const row_place = std::remainder(place - 0.05, 0.1);
    EXPECT_NEAR(row_place, 0.0, 0.51 * (high - low) / 65534.0 + 1e-7) << ids[i];
  }
  EXPECT_EQ(particles.at("probes").size(), 2u);
  EXPECT_FALSE(particles.at("walls").is_null());
}

TEST_F(RunReport, OutlinesWallsWithoutParticles) {
  std::string text = small_tank;
  for (auto const& [from, to] :
       {std::pair<std::string, std::string>{"[[wall]]\n", "[[wall]]\nmethod = \"mirror\"\n"},
        {"[1.9, 1.9]", "[0.1, 0.9]"}})
    text.replace(text.find(from), from.size(), to);
  run("one", text);
  PageReader const page = report({"one"});
  auto const& walls = page.run().at("particles").at("walls");
  EXPECT_EQ(walls.at("frames").size(), 0u);
  EXPECT_EQ(walls.at("boxes").at(0).at("name"), "tank");
  EXPECT_EQ(page.run().at("particles").at("box").at("max").at(1), 1.0) << "the whole tank";
}

TEST_F(RunReport, MarksDefaultsAmongTheSettings) {
  run("one");
  PageReader const page = report({"one"});
  auto const& settings = page.run().at("settings");
  auto const of = [&](std::string const& section, std::string const& key) {
    for (auto const& setting : settings)
      if (setting.at("section") == section && setting.at("key") == key) return setting;
    ADD_FAILURE() << section << ' ' << key;
    return nlohmann::ordered_json();
  };
  EXPECT_EQ(of("resolution", "spacing").at("is_default"), false);
  EXPECT_EQ(of("resolution", "spacing").at("value"), "0.1");
  EXPECT_EQ(of("resolution", "spacing").at("unit"), "m");
  EXPECT_EQ(of("time", "courant").at("is_default"), true);
  EXPECT_EQ(of("wall tank", "slip").at("is_default"), true);
}

TEST_F(RunReport, DrawsRunsOverEachOther) {
  run("one");
  std::filesystem::create_directories(path("other"));
  run("other/one");
  PageReader const page = report({"one", "other/one"});
  EXPECT_EQ(page.report().at("runs").size(), 2u);
  EXPECT_EQ(page.run(0).at("name"), "one");
  EXPECT_EQ(page.run(1).at("name"), "one (2)");
  EXPECT_EQ(page.run(1).at("title"), "one (2)") << "their titles are the same";
  EXPECT_EQ(page.gauge("a <i>gauge</i> pressure", 0), page.gauge("a <i>gauge</i> pressure", 1));
}

TEST_F(RunReport, StaysWithinItsSizeAndSaysWhatItLeavesOut) {
  std::string fine = small_tank;
  fine.replace(fine.find("spacing = 0.1"), 13, "spacing = 0.0125");  // else all of them are little
  fine.replace(fine.find("fixed_step = 0.001"), 18, "fixed_step = 0.0005");
  run("one", fine);
  ReportOptions small;
  small.most_bytes = std::filesystem::file_size([&] {
                       report({"one"});
                       return path("report.html");
                     }()) -
                     6000;
  PageReader const page = report({"one"}, small);
  EXPECT_LE(std::filesystem::file_size(path("report.html")), small.most_bytes);
  EXPECT_NE(page.run().at("particles").at("note"), "");
}

/// Nothing of particles: then there is no player either.
void drop_particles(std::filesystem::path const& run) {
  std::filesystem::remove(run / "particles.pvd");
  std::filesystem::remove_all(run / "frames");
}

bool has_note(nlohmann::ordered_json const& run, std::string const& words) {
  for (auto const& each : run.at("quality"))
    if (each.at("value").get<std::string>().find(words) != std::string::npos) return true;
  return false;
}

TEST_F(RunReport, OfVeryManyColumnsStaysWithinItsSize) {
  run("one");
  drop_particles(path("one"));
  std::string text = "time [s]";
  for (int k = 0; k < 3000; ++k) text += ",P[" + std::to_string(k) + "] pressure [Pa]";
  for (int row = 0; row < 900; ++row) {
    text += "\n" + std::to_string(row);
    for (int k = 0; k < 3000; ++k) text += "," + std::to_string((row * 7919 + k * 104729) % 99991);
  }
  write(path("one/gauges.csv"), text + "\n");
  PageReader const page = report({"one"});
  EXPECT_LE(std::filesystem::file_size(path("report.html")), 1'000'000u);
  EXPECT_GT(std::filesystem::file_size(path("report.html")), 700'000u) << "and uses it";
  EXPECT_TRUE(has_note(page.run(), "of the 3000 columns of gauges.csv are left out"));
  auto const& table = page.run().at("tables").at(0);
  EXPECT_GT(table.at("columns").size(), 100u);
  EXPECT_GE(table.at("rows"), 200);
  EXPECT_EQ(table.at("rows_of"), 900);
}

TEST_F(RunReport, OfManyRunsStaysWithinItsSize) {
  run("one");
  drop_particles(path("one"));
  std::vector<std::string> names{"one"};
  for (int k = 1; k < 300; ++k) {
    names.push_back("run" + std::to_string(k));
    std::filesystem::copy(path("one"), path(names.back()),
                          std::filesystem::copy_options::recursive);
  }
  ReportOptions options;
  options.sweep = {{"members", nlohmann::ordered_json::array()}};
  for (int k = 0; k < 300; ++k) options.sweep["members"].push_back({{"run", k}});
  PageReader const page = report(names, options);
  EXPECT_LE(std::filesystem::file_size(path("report.html")), 1'000'000u);
  std::size_t const kept = page.report().at("runs").size();
  EXPECT_GT(kept, 30u);
  ASSERT_LT(kept, 300u);
  EXPECT_TRUE(has_note(page.run(), "of 300 runs are left out"));
  EXPECT_FALSE(page.run().at("settings").empty());
  EXPECT_TRUE(has_note(page.run(1), "settings are left out"));
  auto const& members = page.report().at("sweep").at("members");
  EXPECT_EQ(members.at(kept - 1).at("run"), kept - 1);
  EXPECT_TRUE(members.at(kept).at("run").is_null());
  std::size_t with_curves = 0;
  for (auto const& each : page.report().at("runs"))
    with_curves += each.at("tables").empty() ? 0 : 1;
  EXPECT_GT(with_curves, 20u);
}

TEST_F(RunReport, ReadsNoParticlesWithoutRoomForThem) {
  run("one");
  for (auto const& frame : std::filesystem::directory_iterator(path("one/frames")))
    write(frame.path(), "nothing of the kind");
  EXPECT_TRUE(has_note(report({"one"}).run(), "particles are left out"));
  ReportOptions small;
  small.most_bytes = 700'000;  // those of the page and the player, and a little more
  EXPECT_FALSE(has_note(report({"one"}, small).run(), "particles are left out"));
}

TEST_F(RunReport, OfAFolderThatMissesPiecesSaysWhich) {
  run("one");
  write(path("one/gauges.csv"), "time [s],a\n1,x\n");
  write(path("one/case.used.toml"), "nothing of the kind");
  write(path("one/status.json"), "[]");
  PageReader const page = report({"one"});
  int notes = 0;
  for (auto const& each : page.run().at("quality"))
    if (each.at("name") == "files") ++notes;
  EXPECT_EQ(notes, 3);
  EXPECT_EQ(page.run().at("title"), "one");
  EXPECT_EQ(page.run().at("state"), "ended") << "told by the manifest";
}

TEST_F(RunReport, OfNoRunIsRefused) {
  std::filesystem::create_directories(path("empty"));
  EXPECT_NE(message_of<InputErrors>([&] { report({"empty"}); }).find("holds no run"),
            std::string::npos);
  EXPECT_NE(message_of<InputErrors>([&] { report({"none"}); }).find("does not exist"),
            std::string::npos);
}

TEST_F(RunReport, OfAMillionParticlesShowsAShareOfThem) {
  run("one");
  ParticleStore store(3);
  for (std::size_t i = 0; i < 1'000'000; ++i) {
    std::size_t const p = store.append(Kind::fluid, 0);
    store.component(Field::position, 0)[p] = 1e-2 * static_cast<double>(i % 100);
    store.component(Field::position, 1)[p] = 1e-2 * static_cast<double>(i / 100 % 100);
    store.component(Field::position, 2)[p] = 1e-2 * static_cast<double>(i / 10'000);
    store.scalar(Field::pressure)[p] = std::sin(static_cast<double>(i));
  }
  PvdCollection frames(path("one/particles.pvd"));
  write_vtp(path("one/frames/particles_000000.vtp"), store, Kind::fluid, 0.0);
  for (int i = 0; i < 2; ++i) frames.add(0.1 * i, frame_name(0));
  PageReader const page = report({"one"});
  EXPECT_LE(std::filesystem::file_size(path("report.html")), 15'000'000u);
  auto const& particles = page.run().at("particles");
  EXPECT_EQ(particles.at("total"), 1'000'000);
  EXPECT_GT(particles.at("shown").get<int>(), 40'000);
  EXPECT_LE(particles.at("shown").get<int>(), 51'000);
  EXPECT_NE(particles.at("note").get<std::string>().find("of 1\u202f000\u202f000 particles"),
            std::string::npos);
}

}  // namespace
}  // namespace moraine::report
