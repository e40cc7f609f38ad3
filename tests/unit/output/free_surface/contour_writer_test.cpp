// What the header of a surface file says is what its blocks hold.
#include "output/free_surface/contour_writer.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "output/free_surface/contour.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class ContourFile : public ScratchFolder {
 protected:
  std::string written(Contour const& contour) {
    write_contour(path("surface.vtp"), contour, 0.25);
    return bytes_of(path("surface.vtp"));
  }
};

TEST_F(ContourFile, HoldsATetrahedron) {
  Contour const four{3,
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  std::string const file = written(four);
  EXPECT_NE(file.find("NumberOfPoints=\"4\""), std::string::npos);
  EXPECT_NE(file.find("NumberOfPolys=\"4\""), std::string::npos);
  EXPECT_NE(file.find("NumberOfLines=\"0\""), std::string::npos);
  EXPECT_NE(file.find("format=\"ascii\">0.25<"), std::string::npos);
  // Normals, points, corners of triangles and their ends, each behind its size.
  std::size_t const data = file.find('_', file.find("<AppendedData")) + 1;
  std::size_t const end = file.find("\n</AppendedData>", data);
  EXPECT_EQ(end - data, 4 * 8U + 48U + 48U + 12 * 8U + 4 * 8U);
  std::int64_t corner = 0;
  std::memcpy(&corner, file.data() + data + 3 * 8 + 48 + 48 + 8, sizeof corner);
  EXPECT_EQ(corner, 2);
  EXPECT_NEAR(content_of(four), 1.0 / 6.0, 1e-15);
}

TEST_F(ContourFile, HoldsLines) {
  std::string const file = written({2,
                                    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                    {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                    {0, 1, 1, 2, 2, 0}});
  EXPECT_NE(file.find("NumberOfLines=\"3\""), std::string::npos);
  EXPECT_NE(file.find("NumberOfPolys=\"0\""), std::string::npos);
  EXPECT_NE(file.find("<Lines>"), std::string::npos);
}

}  // namespace
}  // namespace moraine
