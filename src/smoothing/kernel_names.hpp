// The closed lists of smoothing kernels, and of means of two smoothing lengths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace moraine {

enum class KernelName : std::uint8_t {
  cubic_spline,
  wendland_c2,
  wendland_c4,
  wendland_c6,
  quartic_spline,
  quintic_spline,
  gaussian,
  super_gaussian,
  lucy,
  johnson_quadratic,
  dome,
  liu_quartic
};

struct KernelInfo {
  KernelName kernel;
  std::string_view name;   // in case files
  std::string_view words;  // in messages
};

inline constexpr std::array kernel_table{
    KernelInfo{KernelName::cubic_spline, "cubic_spline", "cubic spline"},
    KernelInfo{KernelName::wendland_c2, "wendland_c2", "Wendland C2"},
    KernelInfo{KernelName::wendland_c4, "wendland_c4", "Wendland C4"},
    KernelInfo{KernelName::wendland_c6, "wendland_c6", "Wendland C6"},
    KernelInfo{KernelName::quartic_spline, "quartic_spline", "quartic spline"},
    KernelInfo{KernelName::quintic_spline, "quintic_spline", "quintic spline"},
    KernelInfo{KernelName::gaussian, "gaussian", "Gaussian"},
    KernelInfo{KernelName::super_gaussian, "super_gaussian", "super-Gaussian"},
    KernelInfo{KernelName::lucy, "lucy", "Lucy's kernel"},
    KernelInfo{KernelName::johnson_quadratic, "johnson_quadratic", "Johnson's quadratic"},
    KernelInfo{KernelName::dome, "dome", "dome"},
    KernelInfo{KernelName::liu_quartic, "liu_quartic", "Liu's quartic"},
};

constexpr KernelInfo const& info(KernelName kernel) {
  return kernel_table[static_cast<std::size_t>(kernel)];
}

/// Name in case files.
constexpr std::string_view kernel_name(KernelName kernel) { return info(kernel).name; }

/// Support radius of all kernels in smoothing lengths. The h of a case is half the radius of the
/// support. A kernel whose own formula ends at another kappa is written in q = (kappa / 2) r / h
/// there, so that a change of kernel keeps the support and with it the number of neighbours.
inline constexpr double kernel_support = 2.0;

/// The smoothing length of a pair; smoothing/pair_smoothing.hpp.
enum class PairSmoothing : std::uint8_t { arithmetic, geometric, largest, smallest };

}  // namespace moraine
