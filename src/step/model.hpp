// What a simulation starts from: particles, materials, walls and settings, ready to run.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "matter/eos/eos.hpp"
#include "step/guard.hpp"
#include "step/settings.hpp"
#include "step/stages.hpp"
#include "store/particle_store.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

struct Material {
  std::string name;
  Eos eos;
};

struct Model {
  int dimension = 3;
  std::array<double, 3> domain_min{};  // m
  std::array<double, 3> domain_max{};  // m
  std::array<bool, 3> periodic{};
  std::array<double, 3> gravity{};  // m/s^2
  Numerics numerics;
  TimeSpec time;
  GuardSettings guards;
  std::vector<Material> materials;  // by MaterialId
  ParticleStore particles{3};
  WallData walls;
  std::vector<Stage> stages;  // in their order; none: one stage without a name
  Flavour flavour() const {
    return numerics.precision == Precision::mixed ? Flavour::mixed : Flavour::full;
  }
};

}  // namespace moraine
