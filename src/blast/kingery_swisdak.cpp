#include "blast/kingery_swisdak.hpp"

#include <array>
#include <cmath>
#include <span>

namespace moraine::blast {
namespace {

/// ln Y as a polynomial of ln Z up to `end` [m/kg^(1/3)].
struct Piece {
  double end;
  std::array<double, 7> coefficients;  // zero behind the last one
};

// kPa, ms/kg^(1/3), kPa ms/kg^(1/3), km/s.
constexpr Piece arrival_time[] = {{1.5, {-0.7604, 1.8058, 0.1257, -0.0437, -0.031, -0.00669}},
                                  {40, {-0.7137, 1.5732, 0.5561, -0.4213, 0.1054, -0.00929}}};
constexpr Piece overpressure[] = {{2.9, {7.2106, -2.1069, -0.3229, 0.1117, 0.0685}},
                                  {23.8, {7.5938, -3.0523, 0.40977, 0.0261, -0.01267}},
                                  {198.5, {6.0536, -1.4066}}};
constexpr Piece reflected_overpressure[] = {
    {2, {9.006, -2.6893, -0.6295, 0.1011, 0.29255, 0.13505, 0.019736}},
    {40, {8.8396, -1.733, -2.64, 2.293, -0.8232, 0.14247, -0.0099}}};
constexpr Piece duration[] = {{1.02, {0.5426, 3.2299, -1.5931, -5.9667, -4.0815, -0.9149}},
                              {2.8, {0.544, 2.7082, -9.7354, 14.3425, -9.7791, 2.8535}},
                              {40, {-2.4608, 7.1639, -5.6215, 2.2711, -0.44994, 0.03486}}};
constexpr Piece impulse[] = {{0.96, {5.522, 1.117, 0.6, -0.292, -0.087}},
                             {2.38, {5.465, -0.308, -1.464, 1.362, -0.432}},
                             {33.7, {5.2749, -0.4677, -0.2499, 0.0588, -0.00554}},
                             {158.7, {5.9825, -1.062}}};
constexpr Piece reflected_impulse[] = {{40, {6.7853, -1.3466, 0.101, -0.01123}}};
constexpr Piece front_speed[] = {{1.5, {0.1794, -0.956, -0.0866, 0.109, 0.0699, 0.01218}},
                                 {40, {0.2597, -1.326, 0.3767, 0.0396, -0.0351, 0.00432}}};

double evaluate(std::span<Piece const> pieces, double scaled_distance) {
  Piece const* piece = pieces.data();
  while (piece != &pieces.back() && scaled_distance > piece->end) ++piece;
  double const x = std::log(scaled_distance);
  double sum = 0.0;
  for (auto c = piece->coefficients.rbegin(); c != piece->coefficients.rend(); ++c)
    sum = sum * x + *c;
  return std::exp(sum);
}

}  // namespace

double swisdak_overpressure(double scaled_distance) {
  return 1e3 * evaluate(overpressure, scaled_distance);
}

double swisdak_reflected_overpressure(double scaled_distance) {
  return 1e3 * evaluate(reflected_overpressure, scaled_distance);
}

double swisdak_arrival_time(double scaled_distance) {
  return 1e-3 * evaluate(arrival_time, scaled_distance);
}

double swisdak_duration(double scaled_distance) {
  return 1e-3 * evaluate(duration, scaled_distance);
}

double swisdak_impulse(double scaled_distance) { return evaluate(impulse, scaled_distance); }

double swisdak_reflected_impulse(double scaled_distance) {
  return evaluate(reflected_impulse, scaled_distance);
}

double swisdak_front_speed(double scaled_distance) {
  return 1e3 * evaluate(front_speed, scaled_distance);
}

}  // namespace moraine::blast
