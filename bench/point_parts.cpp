// What is done per particle or per pair without neighbours: kernels and equations of state.
#include <vector>

#include "smoothing/any_kernel.hpp"
#include "state.hpp"

namespace moraine::parts {
namespace {

constexpr std::size_t count = 4096;  // in the first-level cache, read and written

void kernel_slope(benchmark::State& run, auto const& kernel) {
  using Lane = Simd<float, widest_float>;
  std::vector<float> q(count), slope(count);
  for (std::size_t i = 0; i < count; ++i) q[i] = 2.2f * static_cast<float>(i) / count;
  for (auto _ : run) {
    for (std::size_t i = 0; i < count; i += Lane::size()) {
      Lane const value = kernel.slope_over_q(Lane::load(q.data() + i));
      std::memcpy(slope.data() + i, &value.v, sizeof(value.v));
    }
    benchmark::ClobberMemory();
  }
  run.counters["values"] = per_second(count);
}
BENCHMARK_CAPTURE(kernel_slope, wendland_c2, WendlandC2<3>{});
BENCHMARK_CAPTURE(kernel_slope, cubic_spline, CubicSpline<3>{});
BENCHMARK_CAPTURE(kernel_slope, wendland_c2_by_name, AnyKernel<3>(KernelName::wendland_c2));
BENCHMARK_CAPTURE(kernel_slope, quintic_spline_by_name, AnyKernel<3>(KernelName::quintic_spline));
BENCHMARK_CAPTURE(kernel_slope, gaussian_by_name, AnyKernel<3>(KernelName::gaussian));

template <class Law>
void respond(benchmark::State& run) {
  Law const law{};
  std::vector<double> density(count), pressure(count), sound_speed(count);
  for (std::size_t i = 0; i < count; ++i)
    density[i] = law.reference_density * (0.99 + 0.02 * static_cast<double>(i) / count);
  for (auto _ : run) {
    for (std::size_t i = 0; i < count; ++i) {
      auto const state = law.respond(density[i], law.reference_energy);
      pressure[i] = state.pressure;
      sound_speed[i] = state.sound_speed;
    }
    benchmark::ClobberMemory();
  }
  run.counters["particles"] = per_second(count);
}
BENCHMARK_TEMPLATE(respond, Tait);
BENCHMARK_TEMPLATE(respond, WaterPolynomial);
BENCHMARK_TEMPLATE(respond, Jwl);
BENCHMARK_TEMPLATE(respond, IdealGas);

}  // namespace
}  // namespace moraine::parts
