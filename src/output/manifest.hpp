// What a run was: program, settings of the build, case file, time, and how it ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "step/stages.hpp"

namespace moraine {

/// What the program was built from and how. Absent pieces are "unknown".
struct BuildInfo {
  std::string version;       // MORAINE_VERSION
  std::string git_revision;  // MORAINE_GIT_REVISION
  std::string compiler;
  std::string compiler_flags;  // MORAINE_COMPILER_FLAGS
  std::string simd;            // instruction set of the pair loops
};

/// This build, from the compiler and from the macros named in BuildInfo, which the build system
/// defines as string literals.
BuildInfo build_info();

/// How a run ended.
struct RunEnd {
  std::string reason;           // "end time reached", "interrupted", "guard: ..."
  double wall_time = 0.0;       // s, of the whole run, through its checkpoints
  double simulated_time = 0.0;  // s
  std::uint64_t steps = 0;
  std::uint64_t particles = 0;  // left at the end
};

/// The state of another run that this one started from.
struct RunStart {
  std::string run;         // folder, seen from that of the case file
  std::string checkpoint;  // file name
  std::string sha256;      // digest of that file's bytes
  double time = 0.0;       // s
  std::uint64_t step = 0;
};

/// Everything that manifest.json holds. Nothing in it names the machine.
struct Manifest {
  BuildInfo build;
  int threads = 1;
  std::string precision;          // "mixed" or "double"
  std::string case_file;          // only its file name is written
  std::string case_sha256;        // digest of the case file's bytes
  std::string start_time;         // UTC, ISO 8601, see utc_now
  std::uint64_t particles = 0;    // at the start, walls included
  std::optional<RunStart> start;  // absent where all particles are those of regions
  std::vector<std::uint64_t> resumed_at_steps;
  std::vector<StageEvent> stages;  // that have begun
  std::optional<RunEnd> end;       // absent while the run goes on
};

/// The time now as `2026-01-31T12:34:56Z`.
std::string utc_now();

/// SHA-256 of a file's bytes. Throws std::runtime_error if it cannot be read.
std::string file_sha256(std::filesystem::path const& path);

/// Writes the manifest as JSON; "state" is "running" until `end` is given, then "ended", so that a
/// killed run shows. The file appears complete or not at all.
void write_manifest(std::filesystem::path const& path, Manifest const& manifest);

}  // namespace moraine
