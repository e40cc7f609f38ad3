#include "output/sloshing/tank_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "output/text_columns.hpp"

namespace moraine {
namespace {

std::string four(double value) { return fmt::format("{:.4g}", value); }

std::string modes_text(TankReport const& report) {
  TextColumns table({"mode"});
  for (auto const* heading : {"frequency Hz", "period s", "mass kg", "share", "height m",
                              "with floor m", "on a spring m"})
    table.add_column(heading);
  for (int n = 1; n <= report.modes; ++n) {
    SloshingMode const mode = sloshing_mode(report.tank, n);
    std::vector<std::string> cells{fmt::format("{}", n), four(mode.frequency()),
                                   four(mode.period())};
    if (mode.mass > 0.0)
      for (double const value : {mode.mass, mode.mass / report.tank.mass(), mode.height.walls,
                                 mode.height.walls_and_floor, mode.spring_height})
        cells.push_back(four(value));
    else
      cells.emplace_back("not driven");
    table.add_row(std::move(cells));
  }
  return table.text();
}

/// A figure by linear theory and by Housner.
struct Comparison {
  char const* label;
  char const* unit;
  char const* key;
  double linear;
  double housner;
};

std::vector<Comparison> comparisons(RigidTank const& tank) {
  ImpulsiveMass const impulsive = impulsive_mass(tank);
  SloshingMode const first = sloshing_mode(tank, 1);
  HousnerTank const housner = housner_tank(tank);
  double const m = tank.mass();
  ForceHeight const& h = housner.impulsive.height;
  ForceHeight const& c = housner.convective_height;
  double const housner_frequency =
      first.frequency() * housner.convective_angular_frequency / first.angular_frequency;
  return {
      {"impulsive mass", "kg", "impulsive_mass_kg", impulsive.mass, housner.impulsive.mass},
      {"  share", "-", "impulsive_share", impulsive.mass / m, housner.impulsive.mass / m},
      {"  height", "m", "impulsive_height_m", impulsive.height.walls, h.walls},
      {"  with floor", "m", "impulsive_height_with_floor_m", impulsive.height.walls_and_floor,
       h.walls_and_floor},
      {"convective mass (mode 1)", "kg", "convective_mass_kg", first.mass, housner.convective_mass},
      {"  share", "-", "convective_share", first.mass / m, housner.convective_mass / m},
      {"  height", "m", "convective_height_m", first.height.walls, c.walls},
      {"  with floor", "m", "convective_height_with_floor_m", first.height.walls_and_floor,
       c.walls_and_floor},
      {"  frequency", "Hz", "convective_frequency_hz", first.frequency(), housner_frequency},
  };
}

std::string masses_text(RigidTank const& tank) {
  TextColumns table({"masses", "unit"});
  for (auto const* heading : {"linear theory", "Housner", "difference"}) table.add_column(heading);
  for (Comparison const& c : comparisons(tank))
    table.add_row({c.label, c.unit, four(c.linear), four(c.housner),
                   fmt::format("{:+.1f} %", 100.0 * (c.housner / c.linear - 1.0))});
  return table.text();
}

/// A figure of a response.
struct Figure {
  char const* label;
  char const* unit;
  char const* key;
  double value;
};

std::vector<Figure> figures(RigidTank const& tank, TankResponse const& r) {
  Range const surface = range_of(r.ground, r.surface), force = range_of(r.ground, r.force),
              walls = range_of(r.ground, r.wall_moment),
              turning = range_of(r.ground, r.turning_moment);
  double const peak = peak_of(r.ground, r.ground.acceleration).value;
  return {
      {"peak acceleration", "m/s²", "peak_acceleration_m_s2", peak},
      {"highest surface at +x wall", "m", "surface_highest_m", surface.largest},
      {"  at", "s", "surface_highest_time_s", surface.largest_time},
      {"lowest surface at +x wall", "m", "surface_lowest_m", surface.smallest},
      {"  at", "s", "surface_lowest_time_s", surface.smallest_time},
      {"largest force along +x", "N", "force_largest_n", force.largest},
      {"  at", "s", "force_largest_time_s", force.largest_time},
      {"largest force along -x", "N", "force_smallest_n", force.smallest},
      {"  at", "s", "force_smallest_time_s", force.smallest_time},
      {"largest force / (mass PGA)", "-", "force_over_mass_and_peak",
       force.size() / (tank.mass() * peak)},
      {"largest moment of walls", "N m", "wall_moment_largest_n_m", walls.size()},
      {"  with floor", "N m", "turning_moment_largest_n_m", turning.size()},
  };
}

std::string responses_text(TankReport const& report) {
  TextColumns table({"response", "unit"});
  std::vector<std::vector<Figure>> columns;
  for (TankResponse const& response : report.responses) {
    table.add_column(response.ground.name);
    columns.push_back(figures(report.tank, response));
  }
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    std::vector<std::string> cells{columns.front()[i].label, columns.front()[i].unit};
    for (auto const& column : columns) cells.push_back(four(column[i].value));
    table.add_row(std::move(cells));
  }
  return table.text();
}

nlohmann::json mode_as_json(SloshingMode const& mode) {
  return {{"number", mode.number},
          {"frequency_hz", mode.frequency()},
          {"period_s", mode.period()},
          {"mass_kg", mode.mass},
          {"height_m", mode.height.walls},
          {"height_with_floor_m", mode.height.walls_and_floor},
          {"spring_height_m", mode.spring_height}};
}

}  // namespace

std::string tank_as_text(TankReport const& report) {
  RigidTank const& tank = report.tank;
  std::string text = fmt::format(
      "rigid tank: length {:.4g} m along the motion, depth {:.4g} m, width {:.4g} m; {:.6g} kg of "
      "liquid; g {:.6g} m/s²\n\n{}\n{}",
      tank.length, tank.depth, tank.width, tank.mass(), tank.gravity, modes_text(report),
      masses_text(tank));
  if (!report.responses.empty())
    text += fmt::format("\n{} odd modes, damping {:g}\n{}", report.settings.modes,
                        report.settings.damping, responses_text(report));
  return text;
}

std::string tank_as_csv(TankReport const& report) {
  if (report.responses.empty()) {
    std::string text =
        "mode,frequency [Hz],period [s],mass [kg],height [m],height with floor [m],height on a "
        "spring [m]\n";
    for (int n = 1; n <= report.modes; ++n) {
      SloshingMode const mode = sloshing_mode(report.tank, n);
      text += fmt::format("{},{},{},{},{},{},{}\n", n, mode.frequency(), mode.period(), mode.mass,
                          mode.height.walls, mode.height.walls_and_floor, mode.spring_height);
    }
    return text;
  }
  std::string text = "figure";
  std::vector<std::vector<Figure>> columns;
  for (TankResponse const& response : report.responses) {
    text += "," + quoted_cell(response.ground.name);
    columns.push_back(figures(report.tank, response));
  }
  text += '\n';
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    text += columns.front()[i].key;
    for (auto const& column : columns) text += fmt::format(",{}", column[i].value);
    text += '\n';
  }
  return text;
}

nlohmann::json tank_as_json(TankReport const& report) {
  RigidTank const& tank = report.tank;
  nlohmann::json json{{"length_m", tank.length},      {"depth_m", tank.depth},
                      {"width_m", tank.width},        {"density_kg_m3", tank.density},
                      {"gravity_m_s2", tank.gravity}, {"mass_kg", tank.mass()}};
  for (int n = 1; n <= report.modes; ++n)
    json["modes"].push_back(mode_as_json(sloshing_mode(tank, n)));
  for (Comparison const& c : comparisons(tank)) {
    json["linear_theory"][c.key] = c.linear;
    json["housner"][c.key] = c.housner;
  }
  json["responses"] = nlohmann::json::array();
  for (TankResponse const& response : report.responses) {
    nlohmann::json entry{{"record", response.ground.name},
                         {"damping", report.settings.damping},
                         {"odd_modes", report.settings.modes}};
    for (Figure const& figure : figures(tank, response)) entry[figure.key] = figure.value;
    json["responses"].push_back(std::move(entry));
  }
  return json;
}

std::vector<std::string> response_doubts(TankReport const& report, double freeboard) {
  std::vector<std::string> doubts;
  double const least = std::min(report.tank.depth, report.tank.length);
  double const period = sloshing_mode(report.tank, 1).period();
  for (TankResponse const& response : report.responses) {
    if (response.ground.time_step > coarse_step * period)
      doubts.push_back(fmt::format(
          "{}: peaks lie between steps of {:.3g} s, since the first mode has a period of {:.3g} s; "
          "--resample makes finer steps",
          response.ground.name, response.ground.time_step, period));
    double const wave = range_of(response.ground, response.surface).size();
    if (wave > small_wave * least)
      doubts.push_back(fmt::format(
          "{}: waves of {:.3g} m are {:.2g} of the {}; linear theory is for small ones, and nature "
          "has higher crests",
          response.ground.name, wave, wave / least,
          report.tank.depth <= report.tank.length ? "depth" : "length"));
    if (freeboard > 0.0 && wave > freeboard)
      doubts.push_back(fmt::format("{}: waves of {:.3g} m are above the freeboard of {:.3g} m",
                                   response.ground.name, wave, freeboard));
  }
  return doubts;
}

std::string response_as_csv(TankResponse const& response) {
  std::string text =
      "time [s],acceleration [m/s^2],surface at +x wall [m],force on tank [N],moment of walls [N "
      "m],moment of walls and floor [N m]\n";
  for (std::size_t i = 0; i < response.ground.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", response.ground.time(i),
                   response.ground.acceleration[i], response.surface[i], response.force[i],
                   response.wall_moment[i], response.turning_moment[i]);
  return text;
}

}  // namespace moraine
