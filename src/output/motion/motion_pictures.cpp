#include "output/motion/motion_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

std::filesystem::path with_suffix(std::filesystem::path const& base, std::string const& suffix) {
  std::filesystem::path result = base;
  return result.replace_filename(base.stem().string() + suffix + base.extension().string());
}

}  // namespace

void draw_ground_histories(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records) {
  std::vector<CurvePanel> panels{
      {"acceleration", "m/s^2", {}}, {"velocity", "m/s", {}}, {"displacement", "m", {}}};
  std::vector<double> const times = common_times(records);
  for (GroundRecord const& record : records) {
    GroundPath const path = integrate(record);
    panels[0].curves.push_back({record.name, at_times(record, record.acceleration, times)});
    panels[1].curves.push_back({record.name, at_times(record, path.velocity, times)});
    panels[2].curves.push_back({record.name, at_times(record, path.displacement, times)});
  }
  plot::draw_stacked_panels(out, "Ground motion", {"time", times}, "s", panels);
}

void draw_response_spectra(std::filesystem::path const& out,
                           std::vector<GroundRecord> const& records, SpectrumRange const& range) {
  std::vector<CurvePanel> panels{{"pseudo acceleration", "m/s^2", {}},
                                 {"relative velocity", "m/s", {}},
                                 {"relative displacement", "m", {}}};
  std::vector<double> const periods = periods_of(range);
  for (GroundRecord const& record : records) {
    auto const spectrum = response_spectrum(record, periods, range.damping);
    panels[0].curves.push_back(
        {record.name, column(spectrum, &SpectralResponse::pseudo_acceleration)});
    panels[1].curves.push_back({record.name, column(spectrum, &SpectralResponse::velocity)});
    panels[2].curves.push_back({record.name, column(spectrum, &SpectralResponse::displacement)});
  }
  plot::draw_stacked_panels(
      out, fmt::format("Response spectra, {:g} % of critical damping", 100.0 * range.damping),
      {"period", periods}, "s", panels);
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

std::vector<std::filesystem::path> draw_motions(std::filesystem::path const& base,
                                                std::vector<GroundRecord> const& records,
                                                SpectrumRange const& range) {
  std::filesystem::path const spectra = with_suffix(base, "-spectra");
  std::filesystem::path const frequencies = with_suffix(base, "-frequencies");
  draw_ground_histories(base, records);
  draw_response_spectra(spectra, records, range);
  draw_frequency_spectra(frequencies, records);
  return {base, spectra, frequencies};
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
