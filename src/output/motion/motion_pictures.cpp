#include "output/motion/motion_pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/gravity.hpp"
#include "output/motion/common_times.hpp"
#include "output/plot/stacked_panels.hpp"
#include "output/text_columns.hpp"
#include "records/fourier_spectrum.hpp"
#include "records/response_spectrum.hpp"

namespace moraine {
namespace {

using plot::CurvePanel;

constexpr std::size_t spectrum_points = 400;
constexpr double highest_frequency = 25.0;  // Hz
constexpr std::size_t frequency_points = 2000;

std::vector<double> periods_of(SpectrumRange const& range) {
  return periods_at_equal_ratios(range.shortest, range.longest, spectrum_points);
}

std::vector<double> column(std::vector<SpectralResponse> const& spectrum,
                           double SpectralResponse::*value) {
  std::vector<double> values;
  for (SpectralResponse const& response : spectrum) values.push_back(response.*value);
  return values;
}

/// A spectrum at other frequencies, straight between its values; zero above its last.
std::vector<double> at_frequencies(FrequencySpectrum const& spectrum,
                                   std::vector<double> const& frequencies) {
  std::vector<double> values;
  for (double const f : frequencies) {
    double const place = f / spectrum.frequency_step;
    auto const k = static_cast<std::size_t>(place);
    if (k + 1 >= spectrum.values.size())
      values.push_back(0.0);
    else
      values.push_back(spectrum.values[k] + (place - static_cast<double>(k)) *
                                                (spectrum.values[k + 1] - spectrum.values[k]));
  }
  return values;
}

/// One for all records, or one for each of a few, which would hide each other.
std::vector<CurvePanel> acceleration_panels(std::vector<GroundRecord> const& records,
                                            std::vector<double> const& times) {
  constexpr std::size_t few = 4;
  CurvePanel const empty{"acceleration", "g", {}};
  std::vector<CurvePanel> panels(records.size() <= few ? records.size() : 1, empty);
  double largest = 0.0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::vector<double> const values = in_g(records[i].acceleration);
    largest = std::max(largest, peak_of(records[i], values).value);
    panels[std::min(i, panels.size() - 1)].curves.push_back(
        {records[i].name, at_times(records[i], values, times)});
  }
  if (panels.size() > 1)
    for (CurvePanel& panel : panels) panel.shown_values = {-largest, largest};
  return panels;
}

std::filesystem::path with_suffix(std::filesystem::path const& base, std::string const& suffix) {
  std::filesystem::path result = base;
  return result.replace_filename(base.stem().string() + suffix + base.extension().string());
}

}  // namespace

void draw_ground_histories(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records) {
  std::vector<double> const times = common_times(records);
  std::vector<CurvePanel> panels = acceleration_panels(records, times);
  CurvePanel velocity{"velocity", "m/s", {}}, displacement{"displacement", "m", {}};
  for (GroundRecord const& record : records) {
    GroundPath const path = integrate(record);
    velocity.curves.push_back({record.name, at_times(record, path.velocity, times)});
    displacement.curves.push_back({record.name, at_times(record, path.displacement, times)});
  }
  panels.push_back(std::move(velocity));
  panels.push_back(std::move(displacement));
  plot::draw_stacked_panels(out, "Ground motion", {"time", times}, "s", panels, plot::Scale::linear,
                            1);
}

void draw_response_spectra(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records, SpectrumRange const& range) {
  std::vector<CurvePanel> panels{{"pseudo acceleration", "g", {}},
                                 {"relative velocity", "m/s", {}},
                                 {"relative displacement", "m", {}}};
  std::vector<double> const periods = periods_of(range);
  for (GroundRecord const& record : records) {
    auto const spectrum = response_spectrum(record, periods, range.damping);
    panels[0].curves.push_back(
        {record.name, in_g(column(spectrum, &SpectralResponse::pseudo_acceleration))});
    panels[1].curves.push_back({record.name, column(spectrum, &SpectralResponse::velocity)});
    panels[2].curves.push_back({record.name, column(spectrum, &SpectralResponse::displacement)});
  }
  plot::draw_stacked_panels(
      out, fmt::format("Response spectra, {:g} % of critical damping", 100.0 * range.damping),
      {"period", periods}, "s", panels, plot::Scale::logarithmic);
}

void draw_frequency_spectra(std::filesystem::path const& out,
                            std::vector<GroundRecord> const& records) {
  std::vector<CurvePanel> panels{{"Fourier amplitude", "m/s", {}},
                                 {"power spectral density", "m^2/s^3", {}}};
  double highest = 0.0;
  for (GroundRecord const& record : records) highest = std::max(highest, 0.5 / record.time_step);
  highest = std::min(highest, highest_frequency);
  std::vector<double> frequencies(frequency_points + 1);
  for (std::size_t i = 0; i < frequencies.size(); ++i)
    frequencies[i] = highest * static_cast<double>(i) / frequency_points;
  for (GroundRecord const& record : records) {
    panels[0].curves.push_back(
        {record.name, at_frequencies(fourier_spectrum(record), frequencies)});
    panels[1].curves.push_back({record.name, at_frequencies(power_spectrum(record), frequencies)});
  }
  plot::draw_stacked_panels(out, "Frequencies", {"frequency", frequencies}, "Hz", panels);
}

std::vector<std::filesystem::path> motion_pictures(std::filesystem::path const& base) {
  return {base, with_suffix(base, "-spectra"), with_suffix(base, "-frequencies")};
}

std::vector<std::filesystem::path> draw_motions(std::filesystem::path const& base,
                                                std::vector<GroundRecord> const& records,
                                                SpectrumRange const& range) {
  std::vector<std::filesystem::path> files = motion_pictures(base);
  draw_ground_histories(files[0], records);
  draw_response_spectra(files[1], records, range);
  draw_frequency_spectra(files[2], records);
  return files;
}

std::string spectra_as_csv(std::vector<GroundRecord> const& records, SpectrumRange const& range) {
  std::vector<double> const periods = periods_of(range);
  std::string text = "period [s]";
  std::vector<std::vector<SpectralResponse>> spectra;
  for (GroundRecord const& record : records) {
    for (auto const* quantity : {"displacement [m]", "velocity [m/s]", "acceleration [m/s^2]",
                                 "pseudo velocity [m/s]", "pseudo acceleration [m/s^2]"})
      text += "," + quoted_cell(record.name + " " + quantity);
    spectra.push_back(response_spectrum(record, periods, range.damping));
  }
  text += '\n';
  for (std::size_t i = 0; i < periods.size(); ++i) {
    text += fmt::format("{}", periods[i]);
    for (auto const& spectrum : spectra)
      text += fmt::format(",{},{},{},{},{}", spectrum[i].displacement, spectrum[i].velocity,
                          spectrum[i].acceleration, spectrum[i].pseudo_velocity,
                          spectrum[i].pseudo_acceleration);
    text += '\n';
  }
  return text;
}

std::string frequencies_as_csv(std::vector<GroundRecord> const& records) {
  std::string text;
  std::vector<FrequencySpectrum> fourier, power;
  std::size_t rows = 0;
  for (GroundRecord const& record : records) {
    for (auto const* quantity :
         {"frequency [Hz]", "Fourier amplitude [m/s]", "power spectral density [m^2/s^3]"})
      text += (text.empty() ? "" : ",") + quoted_cell(record.name + " " + quantity);
    fourier.push_back(fourier_spectrum(record));
    power.push_back(power_spectrum(record));
    rows = std::max(rows, fourier.back().values.size());
  }
  text += '\n';
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t r = 0; r < records.size(); ++r) {
      if (r > 0) text += ',';
      if (k < fourier[r].values.size())
        text += fmt::format("{},{},{}", fourier[r].frequency(k), fourier[r].values[k],
                            power[r].values[k]);
      else
        text += ",,";
    }
    text += '\n';
  }
  return text;
}

}  // namespace moraine
