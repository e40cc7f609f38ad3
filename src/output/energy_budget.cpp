#include "output/energy_budget.hpp"

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

double balance(Simulation const& simulation) {
  return energy_balance(simulation.sums(), simulation.lost(), simulation.booked());
}

/// Rate of the internal energy of all particles [W].
double heating(ParticleStore const& store) {
  auto const mass = store.scalar(Field::mass);
  auto const rate = store.scalar(Field::energy_rate);
  auto const add = [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += mass[i] * rate[i];
    return sum;
  };
  return reduce_blocks(store.range(Kind::fluid).size(), 0.0, add,
                       [](double a, double b) { return a + b; });
}

}  // namespace

EnergyBudget::Amounts EnergyBudget::rates(Simulation const& simulation) {
  EnergyRates rates = simulation.pairs().energy_rates(simulation.particles(), simulation.search());
  EnergyRates const& optional = simulation.optional_terms().energy;
  rates.viscosity += optional.viscosity;
  rates.wall_viscosity += optional.wall_viscosity;
  rates.diffusion += optional.diffusion;
  return {rates.viscosity, rates.wall_viscosity,
          heating(simulation.particles()) - rates.viscosity - rates.wall_viscosity,
          rates.diffusion};
}

void EnergyBudget::tell(Simulation const& simulation) {
  Amounts const now = rates(simulation);
  if (told_++ == 0) {
    start_ = balance(simulation);
  } else {
    double const half = 0.5 * simulation.time_step();
    done_.viscosity += half * (last_.viscosity + now.viscosity);
    done_.wall_viscosity += half * (last_.wall_viscosity + now.wall_viscosity);
    done_.compression += half * (last_.compression + now.compression);
    done_.diffusion += half * (last_.diffusion + now.diffusion);
  }
  last_ = now;
}

void EnergyBudget::tell_new_rates(Simulation const& simulation) { last_ = rates(simulation); }

double EnergyBudget::error(Simulation const& simulation) const {
  return balance(simulation) - start_;
}

void EnergyBudget::exchange(Archive& archive) {
  archive.number("energy_budget/told", told_);
  archive.number("energy_budget/start", start_);
  for (auto const& [name, amounts] : {std::pair("last", &last_), std::pair("done", &done_)}) {
    std::string const path = std::string("energy_budget/") + name;
    archive.number(path + "/viscosity", amounts->viscosity);
    archive.number(path + "/wall_viscosity", amounts->wall_viscosity);
    archive.number(path + "/compression", amounts->compression);
    archive.number(path + "/diffusion", amounts->diffusion);
  }
}

}  // namespace moraine
