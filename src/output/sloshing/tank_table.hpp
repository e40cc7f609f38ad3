// Tables of a rigid tank: its modes, its masses, and its answers to records.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sloshing/tank_response.hpp"

namespace moraine {

/// What is told about a tank.
struct TankReport {
  RigidTank tank;
  int modes = 5;  // first modes, even ones too
  ResponseSettings settings;
  std::vector<TankResponse> responses;
};

/// Modes; impulsive and convective mass by linear theory and by Housner; one column per record.
std::string tank_as_text(TankReport const& report);

/// The modes as CSV, or the records where there are some: one line per figure.
std::string tank_as_csv(TankReport const& report);

/// All of it in SI units, which stand in the names.
nlohmann::json tank_as_json(TankReport const& report);

/// Doubts about a response: steps too coarse for its peaks, waves too high for linear theory, or
/// higher than the walls. `freeboard`
/// in m, 0 where it is not known.
std::vector<std::string> response_doubts(TankReport const& report, double freeboard);

/// Acceleration, surface, force and moments over time as CSV, in SI units.
std::string response_as_csv(TankResponse const& response);

/// Up to this part of the first period, a step misses at most 1.3 % of a peak of the first mode:
/// (pi/20)^2 / 2.
inline constexpr double coarse_step = 0.05;

/// Waves up to this part of the depth count as small.
inline constexpr double small_wave = 0.1;

}  // namespace moraine
