// The simulation loop: one step after another, each an ordered list of labelled actions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "base/timer.hpp"
#include "search/search.hpp"
#include "step/booked_energy.hpp"
#include "step/guards.hpp"
#include "step/model.hpp"
#include "step/smoothing_lengths.hpp"
#include "step/time_step.hpp"
#include "terms/strength/strength_backend.hpp"
#include "walls/face_push.hpp"

namespace moraine {

/// Sums that a closed system conserves. In 2D per metre of thickness, in 1D per square metre.
struct ConservedSums {
  double kinetic_energy = 0.0;           // J
  double internal_energy = 0.0;          // J
  double potential_energy = 0.0;         // J, -m g . x, and that of repulsive walls
  double penalty_energy = 0.0;           // J, of the repulsion between materials
  double mass = 0.0;                     // kg
  std::array<double, 3> momentum{};      // kg m/s
  std::array<double, 3> wall_impulse{};  // N s, of all walls on the fluid since the start
  double total_energy() const {
    return kinetic_energy + internal_energy + potential_energy + penalty_energy;
  }
};

/// Particles that left the domain and were removed, with what they took along. A particle is
/// removed when the neighbour lists are rebuilt next; until then it takes part like any other.
struct LostParticles {
  std::uint64_t count = 0;
  double mass = 0.0;    // kg
  double energy = 0.0;  // J, kinetic + internal + potential

  void add(LostParticles const& other) {
    count += other.count;
    mass += other.mass;
    energy += other.energy;
  }
};

/// Lost particles by the side of the domain that they went through: [2 axis + (0 minus | 1 plus)].
/// A particle beyond several sides went through the one that it is farthest beyond.
using LostThroughSides = std::array<LostParticles, 6>;

/// A run in memory. After construction and after each advance(), all fields of the store belong to
/// time(); rates are those at time().
///
/// Leapfrog in the kick-drift-kick form of Liu & Liu (2003), eqs 6.14-6.17: v, rho and e are
/// advanced by half a step, positions by a whole one, rates are evaluated with v, rho and e
/// predicted to the new time, and the second half kick follows. Second order in time.
class Simulation {
 public:
  explicit Simulation(Model model);

  /// A run that goes on from a saved state of the same model: bit for bit as if it had not stopped.
  /// Throws std::runtime_error when the state does not belong to the model.
  Simulation(Model model, Archive& saved);

  /// Saves the whole state, between two steps.
  void save(Archive& archive);

  bool running() const { return time_ < model_.time.end; }

  /// One step; throws SimulationError when a guard stops the run (docs/guards.md).
  void advance();

  /// Lets all optional guards look now, whether or not a look is due: before a state is kept as a
  /// good one. Throws SimulationError.
  void check() const { guards_.look(*this); }

  /// Calls `call` whenever a stage has begun and the rates of its first state are there: whoever
  /// integrates rates must know those that a step began with.
  void on_new_rates(std::function<void(Simulation const&)> call) {
    on_new_rates_ = std::move(call);
  }

  double time() const { return time_; }  // s
  std::uint64_t step() const { return step_; }
  double time_step() const { return vote_.time_step; }  // s, of the last step
  Vote const& vote() const { return vote_; }            // who limited the last step
  Model const& model() const { return model_; }
  ParticleStore const& particles() const { return model_.particles; }
  Search const& search() const { return search_; }
  PairBackend const& pairs() const { return *pairs_; }
  /// Of the optional terms; zero where there are none.
  OptionOutcome const& optional_terms() const { return option_outcome_; }
  /// Loads of all terms on the wall particles of search().wet_walls(), in their order.
  void loads_on_walls(std::vector<WallLoad>& loads) const;
  /// Loads of all terms on mirror walls, one for each particle that has images there.
  void loads_on_mirrors(std::vector<MirrorLoad>& loads) const;
  LostParticles lost() const;  // through all sides
  LostThroughSides const& lost_through() const { return lost_; }
  BookedEnergy const& booked() const { return booked_; }
  Guards const& guards() const { return guards_; }
  /// The stages that have begun so far.
  std::vector<StageEvent> const& stage_events() const { return stages_.events(); }
  /// Of the run so far; zero where all have one smoothing length.
  SmoothingClips const& smoothing_clips() const { return smoothing_clips_; }
  std::size_t stages_to_come() const { return stages_.to_come(); }
  ConservedSums sums() const;  // of the domain; see Model::symmetry for the whole
  Timers const& timers() const { return timers_; }

  /// Memory of the particle data, lists and records, in bytes.
  std::size_t bytes() const;

  /// The step in order: label and what it does.
  struct ActionInfo {
    std::string_view label;
    std::string_view description;
  };
  static std::span<ActionInfo const> actions();

 private:
  struct Action {
    ActionInfo info;
    void (Simulation::*run)();
    int timer;
  };
  struct Unstarted {};
  Simulation(Model model, Unstarted);
  void exchange(Archive& archive);
  void run_actions(std::size_t first);

  void begin_smoothing();
  void follow_density();
  void clip_smoothing();
  void evaluate_rates();
  void begin_stage();
  void remove_walls(std::span<std::uint64_t const> ids);
  void find_present_walls();
  void transform(Transformation const& change);
  void light_explosives();
  void light(std::size_t particle);

  void change_stage();
  void choose_time_step();
  void kick_and_drift();
  void move_walls();
  void check_places_of_walls() const;
  void find_neighbours();
  void sum_densities();
  void remove_lost();
  void evaluate_matter();
  void predict_stress();
  void gather();
  void continue_into_walls();
  void sum_pairs();
  void book_walls();
  void sum_optional_terms();
  void sum_strength();
  void advance_stress(double dt);
  void kick_and_check();
  void absorb();
  void watch();

  void sort_by_material();
  Vote vote_of_walls() const;
  Vote vote_of_repulsion() const;
  Vote vote_of_burn() const;
  Vote vote_of_options() const;
  Vote vote_of_expansion() const;
  bool density_is_state() const { return model_.numerics.density == DensityForm::continuity; }
  void exchange_options(Archive& archive);
  double speed_of_walls() const;
  void damp(double half);
  [[noreturn]] void fail(Finding finding) const;
  [[noreturn]] void fail_to_advance() const;
  double predict_by() const { return 0.5 * half_step_factor_ * vote_.time_step; }

  Model model_;
  Search search_;
  std::unique_ptr<PairBackend> pairs_;
  std::unique_ptr<OptionBackend> options_;     // none where the case asks for no option
  std::unique_ptr<StrengthBackend> strength_;  // none without solids
  Stages stages_;
  Timers timers_;
  std::vector<Action> sequence_;
  std::vector<std::vector<std::uint32_t>> by_material_;
  Vote vote_;
  Vote acceleration_vote_, motion_vote_;
  SweepOutcome swept_;
  OptionParameters option_parameters_;
  OptionOutcome option_outcome_;
  FacePush pushed_;
  LostThroughSides lost_{};
  std::vector<std::uint32_t> leaving_;  // indices, while lost particles are removed
  std::array<double, 3> wall_impulse_{};
  Guards guards_;
  BookedEnergy booked_;
  SmoothingClips smoothing_clips_;
  std::vector<std::uint8_t> wall_is_present_;  // of the moving walls: 0 where a stage removed it
  double damping_power_ = 0.0;                 // W, at the last rates
  double fastest_ = 0.0;                       // m/s, speed at the end of a step
  std::function<void(Simulation const&)> on_new_rates_;
  double time_ = 0.0;
  double half_step_factor_ = 0.0;  // 0 while rates are evaluated anew, else 1
  std::uint64_t step_ = 0;
};

}  // namespace moraine
