// Any bytes as an STL file: refused with a reason, or triangles of which all else can be asked.
#include <cmath>

#include "fuzzing.hpp"
#include "setup/mesh/mesh_report.hpp"
#include "setup/mesh/stl_reader.hpp"
#include "setup/mesh/winding_number.hpp"

using namespace moraine;

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  std::vector<Triangle> triangles;
  try {
    triangles = parse_stl(fuzzing::text_of(data, size));
  } catch (StlError const& error) {
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
    return 0;
  }
  fuzzing::require(!triangles.empty(), "a file that is accepted has triangles");
  for (Triangle const& triangle : triangles)
    for (Vec3 const& corner : triangle)
      for (double const coordinate : corner)
        fuzzing::require(std::isfinite(coordinate), "coordinates are finite");
  TriangleMesh mesh = weld(triangles);
  MeshReport const report = report_on(mesh);
  fuzzing::require(report.triangles + report.degenerate == triangles.size(), "none is lost");
  defects_text(report);
  if (mesh.triangles.empty()) return 0;
  WindingNumber const winding(std::move(mesh));
  for (Vec3 const& place : {report.min, report.max, Vec3{0.1, 0.2, 0.3}}) winding(place);
  return 0;
}
