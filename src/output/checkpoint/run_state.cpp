#include "output/checkpoint/run_state.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "base/simd_width.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/kept_files.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

// Counts up with every change of what is saved, or of what it means for the steps that follow.
constexpr std::uint64_t layout = 5;

}  // namespace

void exchange_layout(Archive& archive) {
  std::uint64_t found = layout;
  archive.number("layout", found);
  if (found != layout)
    throw std::runtime_error(
        fmt::format("the checkpoint has layout {}, this program goes on from layout {} only: "
                    "use the version in manifest.json",
                    found, layout));
}

void save_run(Archive& archive, Simulation& simulation, RunRecorder& recorder) {
  exchange_layout(archive);
  std::string flavour = simd_flavour;
  archive.text("simd", flavour);
  std::string text = used_case(recorder.kept_case());
  archive.text("case", text);
  simulation.save(archive);
  RecorderState state = recorder.state();
  state.exchange(archive);
  recorder.exchange_memory(archive);
}

bool has_ended(std::filesystem::path const& checkpoint, std::filesystem::path const& folder) {
  bool ended = false;
  restore_hdf5(checkpoint, [&](Archive& archive) {
    exchange_layout(archive);
    std::string text;
    archive.text("case", text);
    double time = 0.0;
    archive.number("time", time);
    ended = time >= parse_case(text, (folder / "case.used.toml").string()).time.end;
  });
  return ended;
}

RestoredRun restore_run(std::filesystem::path const& checkpoint,
                        std::filesystem::path const& folder, int threads) {
  RestoredRun run;
  restore_hdf5(checkpoint, [&](Archive& archive) {
    exchange_layout(archive);
    archive.text("simd", run.simd);
    std::string text;
    archive.text("case", text);
    run.c = parse_case(text, (folder / "case.used.toml").string());
    read_start_copy(run.c, folder);
    check_kept_files(run.c, folder);
    run.simulation = std::make_unique<Simulation>(build_model(run.c), archive);
    run.c.start.particles.reset();
    RecorderState state;
    state.exchange(archive);
    run.recorder = std::make_unique<RunRecorder>(run.c, *run.simulation, folder, threads, state);
    run.recorder->exchange_memory(archive);
  });
  return run;
}

}  // namespace moraine
