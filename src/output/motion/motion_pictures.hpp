// Pictures and tables of ground motions over time, period and frequency.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/ground_record.hpp"

namespace moraine {

/// Which response spectra are wanted.
struct SpectrumRange {
  double shortest = 0.1;  // s, at least five steps of all records
  double longest = 4.0;   // s
  double damping = 0.05;  // -
};

/// Acceleration (up to four records: each in a panel of its own, all to the same scale), velocity
/// and displacement of the ground over time, one line per record.
void draw_ground_histories(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records);

/// Pseudo acceleration, relative velocity and displacement of oscillators over the logarithm of
/// their period.
void draw_response_spectra(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records, SpectrumRange const& range);

/// Fourier amplitude and power spectral density up to 25 Hz.
void draw_frequency_spectra(std::filesystem::path const& out,
                            std::vector<GroundRecord> const& records);

/// The files of draw_motions.
std::vector<std::filesystem::path> motion_pictures(std::filesystem::path const& base);

/// All three: `base` with its ending, and "-spectra" and "-frequencies" put before the ending.
/// Returns the files. The ending must be .svg or .png, else std::invalid_argument.
std::vector<std::filesystem::path> draw_motions(std::filesystem::path const& base,
                                                std::vector<GroundRecord> const& records,
                                                SpectrumRange const& range);

/// Response spectra as CSV at 400 periods of equal ratios: period, and for each record
/// displacement, velocity, acceleration, pseudo velocity and pseudo acceleration, in SI units.
std::string spectra_as_csv(std::vector<GroundRecord> const& records, SpectrumRange const& range);

/// Fourier amplitude and power spectral density as CSV, each record at its own frequencies: three
/// columns for each, in SI units, with empty cells where one has fewer than another.
std::string frequencies_as_csv(std::vector<GroundRecord> const& records);

}  // namespace moraine
