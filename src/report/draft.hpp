// A report while it is put together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

struct Draft {
  Json json;  // type Report of the format
  Blocks blocks;
  std::vector<RunFiles> runs;  // those that are in it, without their tables
  std::size_t size() const;    // in the page
};

/// All but particles in at most `bytes` of the page. Every run may take its share of the room:
/// curves give way first (curves.hpp), then settings; where that is not enough, the first runs have
/// curves and the others none, and those that do not fit at all are left out and lose their numbers
/// in `sweep`. Notes say so. The table of a sweep and the head of the first run are always there.
/// One run is read after the other, so that memory holds the tables of one. Throws InputErrors for
/// folders that hold no run.
Draft without_particles(std::vector<std::filesystem::path> const& folders, Json sweep,
                        std::size_t bytes);

}  // namespace moraine::report
