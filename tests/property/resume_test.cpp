// A run that goes on from a saved state gives the same bits as one that never stopped.
#include <gtest/gtest.h>
#include <omp.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "support/places.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

std::vector<std::uint64_t> bits(Simulation const& simulation) {
  std::vector<double> numbers = state_by_id(simulation.particles());
  numbers.push_back(simulation.time());
  for (double const value : simulation.sums().wall_impulse) numbers.push_back(value);
  numbers.push_back(simulation.booked().total());
  std::vector<std::uint64_t> found;
  for (double const value : numbers) found.push_back(std::bit_cast<std::uint64_t>(value));
  return found;
}

void advance(Simulation& simulation, int steps, int threads) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  for (int step = 0; step < steps; ++step) simulation.advance();
  omp_set_num_threads(before);
}

class Resume : public testing::TestWithParam<std::string> {
 protected:
  /// A shipped case, or "NAME+shaken" with its walls shaken hard, "NAME+quarter" with two planes,
  /// "NAME+rate" and "NAME+density" with smoothing lengths that vary, "NAME+coarse" with twice the
  /// spacing, "NAME+options", "NAME+summed" and "NAME+penalty" with optional terms, "NAME+stressed"
  /// with artificial stress.
  Model model() const {
    auto const [name, variant] = parts();
    Case c = read_case(source_folder() + "/cases/" + name + "/case.toml");
    if (variant == "shaken") {
      RigidMotion& motion = c.walls[0].motion.motion.emplace();
      motion.translation[0] = TimeCourse::formula("0.05 * sin(40 * t)", 1e-4);
      motion.rotation = TimeCourse::formula("0.2 * sin(30 * t)", 1e-4);
      c.domain.min[0] -= 0.5;
      c.domain.max[0] += 0.5;
    }
    if (variant == "coarse") c.numerics.spacing *= 2.0;
    if (variant == "rate") c.numerics.smoothing.mode = SmoothingMode::rate;
    if (variant == "density") c.numerics.smoothing.mode = SmoothingMode::density;
    for (std::size_t axis = 0; variant == "quarter" && axis < 2; ++axis) {
      c.domain.min[axis] = 0.0;
      c.symmetry.planes[axis][0] = true;
    }
    if (variant == "penalty") {
      c.numerics.penalty.strength = 1e3;
      c.numerics.xsph = 0.3;
      return build_model(c);
    }
    Model model = build_model(c);
    if (variant == "stressed") model.numerics.artificial_stress = 0.3;
    if (variant == "options") return with_options(std::move(model));
    if (variant == "summed") return with_summed_density(std::move(model));
    return model;
  }
  static std::pair<std::string, std::string> parts() {
    std::string const name = GetParam();
    auto const plus = name.find('+');
    return {name.substr(0, plus), plus == std::string::npos ? "" : name.substr(plus + 1)};
  }
  std::unique_ptr<Simulation> saved_and_restored(Simulation& simulation) const {
    auto const path = std::filesystem::temp_directory_path() /
                      ("moraine_resume_" + GetParam() + "_" + std::to_string(getpid()) + ".h5");
    with_hdf5_image([&](Archive& archive) { simulation.save(archive); },
                    [&](FileImage image) { write_file(path, image); });
    std::unique_ptr<Simulation> restored;
    restore_hdf5(
        path, [&](Archive& archive) { restored = std::make_unique<Simulation>(model(), archive); });
    std::filesystem::remove(path);
    return restored;
  }
};

// The moments are odd: shortly after a rebuild of the lists, just before one, and in between; the
// second half runs with another number of threads.
TEST_P(Resume, GivesTheSameBits) {
  Simulation straight(model());
  advance(straight, straight.model().dimension == 3 ? 60 : 150, 2);
  auto const before = straight.search().rebuilds();
  auto resumed = saved_and_restored(straight);
  for (int const steps : {6, 13, 20}) {
    advance(straight, steps, 1);
    advance(*resumed, steps, 3);
    EXPECT_TRUE(bits(straight) == bits(*resumed)) << "step " << straight.step();
    EXPECT_EQ(straight.search().rebuilds(), resumed->search().rebuilds());
    resumed = saved_and_restored(*resumed);
  }
  bool const moving = GetParam() != "hydrostatic-tank" && GetParam() != "sloshing-tank";
  EXPECT_EQ(straight.search().rebuilds() > before, moving) << "rebuilds of the lists";
}

INSTANTIATE_TEST_SUITE_P(Cases, Resume,
                         testing::Values("tnt-in-water", "dam-break-2d", "dam-break-3d",
                                         "hydrostatic-tank", "sod", "sloshing-tank",
                                         "sloshing-tank+shaken", "tnt-in-water+quarter", "tnt-slab",
                                         "tnt-in-water+rate", "sod+density", "dam-break-3d+options",
                                         "tnt-in-water+penalty", "dam-break-2d+summed",
                                         "undex-cole+coarse", "kleefsman", "surface-charge-6cm",
                                         "bed-charge", "crest-charge", "layered-ground+stressed",
                                         "surface-charge-3d+coarse", "buried-charge-3d+coarse"),
                         [](auto const& test) {
                           std::string name = test.param;
                           for (char& letter : name)
                             if (letter == '-' || letter == '+') letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace moraine
