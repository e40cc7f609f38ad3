#include "setup/case_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "setup/check_absorbing.hpp"
#include "setup/check_burn.hpp"
#include "setup/check_options.hpp"
#include "setup/check_strength.hpp"
#include "setup/check_walls.hpp"
#include "setup/geometry.hpp"
#include "setup/parameter.hpp"
#include "setup/region_lattice.hpp"
#include "setup/smoothing_warnings.hpp"
#include "setup/start_particles.hpp"

namespace moraine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Liquid {
  double density, sound_speed, pressure;  // of the reference state
};

class Warnings {
 public:
  Warnings(Case const& c, Simulation const& simulation)
      : case_(c),
        model_(simulation.model()),
        store_(simulation.particles()),
        axes_(static_cast<std::size_t>(c.dimension)),
        fluid_(store_.range(Kind::fluid)) {}

  std::vector<InputProblem> find() {
    for (auto const& gauge : case_.gauges) look_at(gauge);
    auto const lattices = lattices_of_regions(case_);
    for (std::size_t i = 0; i < lattices.size(); ++i)
      if (auto const box = bounding_box(case_.regions[i].shape, case_.dimension))
        look_at_thickness(*box, lattices[i].spacing, "region." + case_.regions[i].name);
    for (auto const& wall : case_.walls)
      if (wall.form == WallForm::solid)
        look_at_thickness(wall.box, case_.numerics.spacing, "wall." + wall.name);
    look_at_sound_speeds();
    add_smoothing_warnings(case_, warnings_);
    add_option_warnings(case_, warnings_);
    add_burn_warnings(case_, warnings_);
    add_strength_warnings(case_, warnings_);
    add_absorbing_warnings(case_, model_, warnings_);
    add_wall_warnings(case_, warnings_);
    add_start_warnings(case_, warnings_);
    return std::move(warnings_);
  }

 private:
  void warn(std::string const& key, std::string rule, std::string hint = {}) {
    warnings_.push_back(problem_of(case_, key, std::move(rule), std::move(hint)));
  }

  /// The same about a value that need not stand in the file.
  void warn_of_value(std::string const& key, std::string const& value, std::string rule,
                     std::string hint = {}) {
    warn(key, std::move(rule), std::move(hint));
    if (warnings_.back().value.empty()) warnings_.back().value = value;
  }

  double support() const { return kernel_support * case_.numerics.smoothing_length(); }

  double coordinate(std::size_t axis, std::size_t i) const {
    return store_.component(Field::position, static_cast<int>(axis))[i];
  }

  void look_at(GaugeSpec const& gauge) {
    if (gauge.kind == GaugeKind::point) {
      double nearest = infinity;
      for (std::size_t i = fluid_.begin; i < fluid_.end; ++i) {
        double square = 0.0;
        for (std::size_t axis = 0; axis < axes_; ++axis) {
          double const difference = coordinate(axis, i) - gauge.position[axis];
          square += difference * difference;
        }
        nearest = std::min(nearest, square);
      }
      if (std::sqrt(nearest) > support())
        warn("gauge." + gauge.name + ".position",
             fmt::format("starts {:.4g} m from the nearest particle and reads nothing before fluid "
                         "comes within the kernel support, {:.4g} m",
                         std::sqrt(nearest), support()));
    } else if (gauge.kind == GaugeKind::front && !is_there(gauge.material)) {
      warn("gauge." + gauge.name + ".material", "is the material of no particle");
    }
  }

  bool is_there(std::string const& name) const {
    for (std::size_t i = fluid_.begin; i < fluid_.end; ++i)
      if (case_.materials[store_.material()[i]].name == name) return true;
    return false;
  }

  void look_at_thickness(Box const& box, double spacing, std::string const& key) {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      double const extent = box.max[axis] - box.min[axis];
      if (extent >= support()) continue;
      warn(key,
           fmt::format("is {:.4g} m thin along {}, {:.3g} spacings; the kernel reaches {:.4g} m "
                       "(2 h), across all of it",
                       extent, axis_names[axis], extent / spacing, support()),
           "refine the spacing or make it thicker");
    }
  }

  // Against gravity, from the top of the fluid to its bottom or to a container below it.
  double fall_height() const {
    double const g = length(case_.gravity);
    if (g == 0.0) return 0.0;
    auto const height = [&](Point const& x) {
      return -(case_.gravity[0] * x[0] + case_.gravity[1] * x[1] + case_.gravity[2] * x[2]) / g;
    };
    double top = -infinity;
    double bottom = infinity;
    for (std::size_t i = fluid_.begin; i < fluid_.end; ++i) {
      Point x{};
      for (std::size_t axis = 0; axis < axes_; ++axis) x[axis] = coordinate(axis, i);
      double const volume = store_.scalar(Field::mass)[i] / store_.scalar(Field::density)[i];
      double const half = 0.5 * std::pow(volume, 1.0 / case_.dimension);
      top = std::max(top, height(x) + half);
      bottom = std::min(bottom, height(x) - half);
    }
    double lowest = bottom;
    for (auto const& wall : case_.walls)
      if (wall.form == WallForm::container)
        lowest = std::min({lowest, height(wall.box.min), height(wall.box.max)});
    return top - lowest;
  }

  double fastest_start() const {
    double square = 0.0;
    for (std::size_t i = fluid_.begin; i < fluid_.end; ++i) {
      double own = 0.0;
      for (int axis = 0; axis < case_.dimension; ++axis)
        own += std::pow(store_.component(Field::velocity, axis)[i], 2);
      square = std::max(square, own);
    }
    return std::sqrt(square);
  }

  double largest_pressure(std::size_t material) const {
    double pressure = 0.0;
    for (std::size_t i = fluid_.begin; i < fluid_.end; ++i)
      if (store_.material()[i] == material)
        pressure = std::max(pressure, store_.scalar(Field::pressure)[i]);
    return pressure;
  }

  // Of a liquid whose sound speed is a choice; nothing for other materials.
  static std::optional<Liquid> liquid(Eos const& eos) {
    return std::visit(
        [](auto const& law) -> std::optional<Liquid> {
          if constexpr (requires { law.background_pressure; })
            return Liquid{law.reference_density, law.reference_sound_speed,
                          law.background_pressure};
          else
            return std::nullopt;
        },
        eos);
  }

  void look_at_sound_speeds() {
    double const fall = std::sqrt(2.0 * length(case_.gravity) * fall_height());
    bool const slow = std::all_of(case_.materials.begin(), case_.materials.end(),
                                  [](auto const& m) { return liquid(m.eos).has_value(); });
    for (std::size_t m = 0; m < case_.materials.size(); ++m) {
      auto const found = liquid(case_.materials[m].eos);
      if (!found) continue;
      double const excess = std::max(0.0, largest_pressure(m) - found->pressure);
      double const pushed = std::sqrt(2.0 * excess / found->density);
      double const speed = std::max({fall, fastest_start(), pushed});
      if (speed == 0.0) continue;
      double const ratio = found->sound_speed / speed;
      std::string const key = "material." + case_.materials[m].name + ".reference_sound_speed";
      std::string const value = fmt::format("{:.4g} m/s", found->sound_speed);
      if (ratio < 9.9)  // ten times, up to the rounding of who computed it by hand
        warn_of_value(
            key, value,
            fmt::format("is {:.3g} times the speed to expect, {:.3g} m/s; with less than ten "
                        "times the density varies by more than 1 %",
                        ratio, speed));
      else if (ratio > 100.0 && slow)
        warn_of_value(
            key, value,
            fmt::format("is {:.3g} times the speed to expect, {:.3g} m/s; ten times would take "
                        "{:.3g} times fewer steps",
                        ratio, speed, ratio / 10.0));
    }
  }

  Case const& case_;
  Model const& model_;
  ParticleStore const& store_;
  std::size_t axes_;
  Range fluid_;
  std::vector<InputProblem> warnings_;
};

}  // namespace

std::vector<InputProblem> warnings_at_start(Case const& c, Simulation const& simulation) {
  return Warnings(c, simulation).find();
}

void add_output_warnings(Case const& c, double time_step, std::vector<InputProblem>& warnings) {
  constexpr double most_frames = 10000.0;
  auto const& output = c.output;
  auto const look = [&](std::string const& key, double interval) {
    if (interval == 0.0) return;
    if (interval > c.time.end)
      warnings.push_back(problem_of(
          c, key, fmt::format("is longer than the run, which ends at {:.4g} s", c.time.end)));
    else if (interval < time_step)
      warnings.push_back(
          problem_of(c, key,
                     fmt::format("is shorter than the first time step, {:.3g} s: every step is "
                                 "written",
                                 time_step)));
  };
  look("output.frames", output.frame_interval);
  look("output.gauges", output.gauge_interval);
  look("output.sums", output.sums_interval);
  if (output.frame_interval > 0.0 && c.time.end / output.frame_interval > most_frames)
    warnings.push_back(problem_of(c, "output.frames",
                                  fmt::format("makes {:.0f} frames until {:.4g} s",
                                              c.time.end / output.frame_interval, c.time.end)));
  for (double const time : output.frame_times)
    if (time > c.time.end)
      warnings.push_back(
          problem_of(c, "output.frame_times",
                     fmt::format("asks for a frame at {:.4g} s, after the end of the run, {:.4g} s",
                                 time, c.time.end)));
}

}  // namespace moraine
