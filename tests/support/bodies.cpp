#include "support/bodies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

// Two triangles of a patch whose corners are counterclockwise seen from outside.
void add_patch(std::vector<Triangle>& triangles, Vec3 const& a, Vec3 const& b, Vec3 const& c,
               Vec3 const& d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

void add_number(std::string& bytes, double value) {
  auto const number = static_cast<float>(value);
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}

}  // namespace

std::vector<Triangle> cube(Vec3 const& min, double edge) {
  auto const at = [&](int x, int y, int z) {
    return Vec3{min[0] + edge * x, min[1] + edge * y, min[2] + edge * z};
  };
  std::vector<Triangle> t;
  add_patch(t, at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
  add_patch(t, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  add_patch(t, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  add_patch(t, at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
  add_patch(t, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  add_patch(t, at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
  return t;
}

std::vector<Triangle> sphere(double radius, int rings) {
  auto const at = [&](int ring, int k) {
    if (ring == 0) return Vec3{0, 0, radius};
    if (ring == rings) return Vec3{0, 0, -radius};
    double const polar = pi * ring / rings, turn = pi * (k % (2 * rings)) / rings;
    return Vec3{radius * std::sin(polar) * std::cos(turn),
                radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar)};
  };
  std::vector<Triangle> t;
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < 2 * rings; ++k) {
      if (ring + 1 < rings) t.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      if (ring > 0) t.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
  return t;
}

std::vector<Triangle> torus(double large, double small, int count) {
  auto const at = [&](int along, int around) {
    double const u = pi * (along % (2 * count)) / count;
    double const v = 2.0 * pi * (around % count) / count;
    double const from_axis = large + small * std::cos(v);
    return Vec3{from_axis * std::cos(u), from_axis * std::sin(u), small * std::sin(v)};
  };
  std::vector<Triangle> t;
  for (int i = 0; i < 2 * count; ++i)
    for (int k = 0; k < count; ++k)
      add_patch(t, at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
  return t;
}

double volume(std::vector<Triangle> const& triangles) {
  double sum = 0.0;
  for (Triangle const& t : triangles) sum += dot(t[0], cross(t[1], t[2])) / 6.0;
  return sum;
}

std::string stl_text(std::vector<Triangle> const& triangles) {
  std::string text = "solid a body\n";
  for (Triangle const& t : triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (Vec3 const& corner : t)
      text += fmt::format("  vertex {} {} {:e}\n", corner[0], corner[1], corner[2]);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid a body\n";
}

std::string stl_binary(std::vector<Triangle> const& triangles) {
  std::string bytes = "solid but binary";
  bytes.resize(80, ' ');
  auto const count = static_cast<std::uint32_t>(triangles.size());
  bytes.append(reinterpret_cast<char const*>(&count), sizeof count);
  for (Triangle const& t : triangles) {
    for (int k = 0; k < 3; ++k) add_number(bytes, 0.0);
    for (Vec3 const& corner : t)
      for (double const coordinate : corner) add_number(bytes, coordinate);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace moraine
