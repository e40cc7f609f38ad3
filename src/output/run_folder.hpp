// The folder of a run: what lies in it by our hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "output/manifest.hpp"

namespace moraine {

/// The state of another run that a run started from, sealed; a run that goes on needs it.
inline constexpr char const* start_copy = "start.h5";

/// True when a folder holds results of a run, finished or not.
bool holds_a_run(std::filesystem::path const& folder);

/// True when the last run in a folder wrote its end into the manifest: it was neither killed nor is
/// it going on.
bool has_written_its_end(std::filesystem::path const& folder);

/// True when the last run in a folder came to its end time, and read a case file with this digest
/// (file_sha256) in a program of this version and revision: its results are those that a run now
/// would give.
bool has_results_of(std::filesystem::path const& folder, std::string const& case_sha256,
                    BuildInfo const& build);

/// Makes the folder of a run, or clears it of what an earlier run wrote: frames, pictures,
/// checkpoints, copies of bodies, snapshots, status and report, requests. Other people's files
/// stay. Throws OutputError.
void make_run_folder(std::filesystem::path const& folder);

/// Name of a frame of particles, and of walls where they move, relative to the folder.
std::string frame_name(std::size_t number);
std::string wall_frame_name(std::size_t number);

/// Name of a frame that was asked for while the run went on, by the step, relative to the folder.
std::string snapshot_name(std::uint64_t step);
std::string wall_snapshot_name(std::uint64_t step);

/// Removes the frames from this number on with the planes of their times, and the pictures and the
/// snapshot that were made of them, and what a killed run left half written. Throws OutputError.
void drop_frames(std::filesystem::path const& folder, std::size_t first);

}  // namespace moraine
