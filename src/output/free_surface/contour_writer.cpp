#include "output/free_surface/contour_writer.hpp"

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "output/atomic_file.hpp"

namespace moraine {
namespace {

static_assert(std::endian::native == std::endian::little, "blocks are copies of memory");

constexpr char file_head[] = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<FieldData>
<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">{}</DataArray>
</FieldData>
<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOfLines="{}" NumberOfStrips="0"
 NumberOfPolys="{}">
<PointData Normals="normal">
)";

std::vector<float> flat(std::vector<Vec3> const& vectors) {
  std::vector<float> numbers;
  numbers.reserve(3 * vectors.size());
  for (Vec3 const& vector : vectors)
    for (double const component : vector) numbers.push_back(static_cast<float>(component));
  return numbers;
}

/// Appends a block and returns its declaration.
template <class T>
std::string block(std::string& data, std::string_view type, std::string_view name, int components,
                  std::vector<T> const& numbers) {
  std::string declaration = fmt::format(
      R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
      type, name, components, data.size());
  std::uint64_t const bytes = numbers.size() * sizeof(T);
  data.append(reinterpret_cast<char const*>(&bytes), sizeof bytes);
  data.append(reinterpret_cast<char const*>(numbers.data()), bytes);
  return declaration + '\n';
}

}  // namespace

void write_contour(std::filesystem::path const& path, Contour const& contour, double time) {
  std::size_t const cells = contour.cells.size() / contour.corners;
  bool const solid = contour.corners == 3;
  std::vector<std::int64_t> const connectivity(contour.cells.begin(), contour.cells.end());
  std::vector<std::int64_t> offsets;
  for (std::size_t k = 1; k <= cells; ++k)
    offsets.push_back(static_cast<std::int64_t>(k * contour.corners));
  std::string data;
  std::string const normals = block(data, "Float32", "normal", 3, flat(contour.normals));
  std::string const points = block(data, "Float32", "Points", 3, flat(contour.points));
  std::string const corners = block(data, "Int64", "connectivity", 1, connectivity);
  std::string const ends = block(data, "Int64", "offsets", 1, offsets);
  char const* const kind = solid ? "Polys" : "Lines";
  AtomicFile file(path);
  file.stream() << fmt::format(file_head, time, contour.points.size(), solid ? 0 : cells,
                               solid ? cells : 0)
                << normals << "</PointData>\n<Points>\n"
                << points << "</Points>\n<" << kind << ">\n"
                << corners << ends << "</" << kind
                << ">\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" << data
                << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

}  // namespace moraine
