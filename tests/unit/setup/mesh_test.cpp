// STL files, what is known of their bodies, and inside and outside of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "setup/mesh/mesh_report.hpp"
#include "setup/mesh/stl_reader.hpp"
#include "setup/mesh/winding_number.hpp"
#include "support/bodies.hpp"

namespace moraine {
namespace {

std::string error_of(std::string const& bytes) {
  try {
    parse_stl(bytes);
  } catch (StlError const& error) {
    return error.what();
  }
  return "no error";
}

TEST(Stl, TextAndBinaryHoldTheSameTriangles) {
  auto const body = cube({-0.5, 0.25, 2.0}, 1.5);  // whole parts of two: exact in single precision
  EXPECT_EQ(parse_stl(stl_text(body)), body);
  EXPECT_EQ(parse_stl(stl_binary(body)), body);
}

TEST(Stl, SeveralSolidsOfATextAreOneBody) {
  auto const body = cube({0, 0, 0}, 1);
  EXPECT_EQ(parse_stl(stl_text(body) + stl_text(body)).size(), 24U);
}

TEST(Stl, WhatIsNoStlSaysWhy) {
  auto const body = cube({0, 0, 0}, 1);
  EXPECT_EQ(error_of(""), "is empty");
  EXPECT_EQ(error_of("PK\x03\x04"),
            "is no STL file: it has 4 bytes and does not begin with \"solid\"");
  EXPECT_EQ(error_of("solid nothing\nendsolid\n"), "holds no triangles");
  std::string text = stl_text(body);
  EXPECT_EQ(error_of(text.substr(0, text.size() - 40)),
            "ends in line 83 where \"endloop\" is expected");
  EXPECT_EQ(error_of(text.replace(text.find("vertex"), 6, "vertax")),
            "has \"vertax\" in line 4 where \"vertex\" is expected");
  text = stl_text(body);
  EXPECT_EQ(error_of(text.replace(text.find("vertex 0"), 8, "vertex nan")),
            "has \"nan\" in line 4 where a finite coordinate is expected");
}

TEST(Stl, TheCountOfABinaryHeaderIsNotTrusted) {
  std::string bytes = stl_binary(cube({0, 0, 0}, 1));
  bytes[0] = 'x';  // no text
  std::string const cut = bytes.substr(0, bytes.size() - 1);
  EXPECT_EQ(error_of(cut),
            "is no STL file, or cut off: its header announces 12 triangles, its length holds 11");
  for (std::size_t i = 80; i < 84; ++i) bytes[i] = '\xff';  // 4e9 triangles, 200 GB
  EXPECT_EQ(error_of(bytes),
            "is no STL file, or cut off: its header announces 4294967295 triangles, its length "
            "holds 12");
}

TEST(Stl, OneChangedByteNeverCrashes) {
  for (std::string const& good : {stl_text(cube({0, 0, 0}, 1)), stl_binary(cube({0, 0, 0}, 1))}) {
    std::size_t refused = 0;
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::string bad = good;
      bad[i] = static_cast<char>(~bad[i]);
      refused += error_of(bad) == "no error" ? 0 : 1;
    }
    EXPECT_GT(refused, 0U);
    EXPECT_LT(refused, good.size());
  }
}

TEST(MeshReport, ClosedBodiesAreWatertight) {
  for (auto const& body : {cube({1, 2, 3}, 2), sphere(1.0, 12), torus(1.0, 0.3, 12)}) {
    MeshReport const report = report_on(weld(body));
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.triangles, body.size());
    // A sum of some hundred terms of the body's size.
    EXPECT_NEAR(report.volume, volume(body), 1e-13 * volume(body) + 1e-13);
  }
  EXPECT_NEAR(report_on(weld(cube({1, 2, 3}, 2))).volume, 8.0, 1e-14);
}

TEST(MeshReport, HolesAreCountedAndLocated) {
  auto body = cube({0, 0, 0}, 1);
  body.erase(body.begin());  // of the bottom
  MeshReport const report = report_on(weld(body));
  EXPECT_FALSE(report.watertight());
  EXPECT_EQ(report.open_edges, 3U);
  EXPECT_EQ(defects_text(report), "3 open edges around (0, 0, 0) to (1, 1, 0)");
}

TEST(MeshReport, OverlappingAndTurnedEdgesAreCounted) {
  auto body = cube({0, 0, 0}, 1);
  body.push_back(body.front());
  MeshReport const twice = report_on(weld(body));
  EXPECT_EQ(twice.overlapping_edges, 3U);
  EXPECT_EQ(twice.open_edges, 0U);
  body = cube({0, 0, 0}, 1);
  std::swap(body.back()[0], body.back()[1]);
  EXPECT_EQ(report_on(weld(body)).turned_edges, 3U);
}

TEST(MeshReport, DefectsFarApartAreDifferentPlaces) {
  auto body = cube({0, 0, 0}, 1);
  auto const other = cube({5, 0, 0}, 1);
  body.insert(body.end(), other.begin(), other.end());
  body.erase(body.begin() + 2);  // a triangle of each top
  body.erase(body.begin() + 13);
  MeshReport const report = report_on(weld(body));
  EXPECT_EQ(report.defects.size(), 2U);
  EXPECT_EQ(defects_text(report, 1),
            "3 open edges around (0, 0, 1) to (1, 1, 1); and 1 more places");
}

TEST(MeshReport, TrianglesWithoutAreaAreLeftOut) {
  auto body = cube({0, 0, 0}, 1);
  body.push_back({Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{1, 0, 0}});
  MeshReport const report = report_on(weld(body));
  EXPECT_EQ(report.degenerate, 1U);
  EXPECT_TRUE(report.watertight());
}

// The winding number of a closed body is a whole number; rounding of some thousand solid angles.
TEST(WindingNumber, IsExactForClosedBodies) {
  double const large = 1.0, small = 0.4;
  WindingNumber const winding(weld(torus(large, small, 24)));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    Vec3 const q{place(random), place(random), place(random) / 3.0};
    double const around = std::hypot(std::hypot(q[0], q[1]) - large, q[2]);
    if (std::abs(around - small) < 0.02) continue;  // between the torus and its triangles
    double const expected = around < small ? 1.0 : 0.0;
    inside += around < small ? 1 : 0;
    EXPECT_NEAR(winding.exact(q), expected, 1e-11);
    EXPECT_NEAR(winding(q), expected, 0.1);  // what its description promises
  }
  EXPECT_GT(inside, 100);
}

TEST(WindingNumber, SmallHolesChangeNothingFarFromThem) {
  auto body = sphere(1.0, 16);
  body.erase(body.begin() + 40);
  WindingNumber const winding(weld(body));
  EXPECT_GT(winding({0, 0, 0}), 0.9);
  EXPECT_LT(winding({0, 0, 1.5}), 0.1);
  for (Triangle& t : body) std::swap(t[0], t[1]);
  EXPECT_LT(WindingNumber(weld(body))({0, 0, 0}), -0.9);
}

}  // namespace
}  // namespace moraine
