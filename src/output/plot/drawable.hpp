// Numbers that pictures can show.
#pragma once

#include <filesystem>
#include <vector>

#include "output/table_csv.hpp"
#include "output/vtp_reader.hpp"

namespace moraine::plot {

/// Sizes from 1e-100 to 1e100 as they are, smaller ones as zero, larger ones as missing (NaN). No
/// quantity of a run lies beyond, and lengths, ratios and squares of what is left stay finite.
void make_drawable(std::vector<double>& values);

/// A table or frame of which all numbers can be drawn. Throws like read_table_csv and read_vtp.
Table read_drawable_table(std::filesystem::path const& csv);
ParticleFrame read_drawable_frame(std::filesystem::path const& vtp);

}  // namespace moraine::plot
