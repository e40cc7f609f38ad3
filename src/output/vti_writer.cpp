#include "output/vti_writer.hpp"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "output/atomic_file.hpp"

namespace moraine {
namespace {

static_assert(std::endian::native == std::endian::little, "blocks are copies of memory");

constexpr char file_head[] = R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{0}" Origin="{1} {2} {3}" Spacing="{4} {5} {6}">
<FieldData>
<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">{7}</DataArray>
</FieldData>
<Piece Extent="{0}">
<PointData Scalars="pressure" Vectors="velocity">
)";

constexpr char with_unit[] =
    R"(><InformationKey name="UNITS_LABEL" location="vtkDataArray">{}</InformationKey></DataArray>
)";

/// Appended blocks and their declarations.
class Blocks {
 public:
  template <class T>
  void add(std::string_view type, std::string_view name, std::string_view unit, int components,
           std::vector<T> const& numbers) {
    head_ += fmt::format(
        R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}")",
        type, name, components, data_.size());
    head_ += unit.empty() ? "/>\n" : fmt::format(with_unit, unit);
    std::uint64_t const bytes = numbers.size() * sizeof(T);
    data_.append(reinterpret_cast<char const*>(&bytes), sizeof bytes);
    data_.append(reinterpret_cast<char const*>(numbers.data()), bytes);
  }
  std::string const& head() const { return head_; }
  std::string const& data() const { return data_; }

 private:
  std::string head_, data_;
};

std::vector<float> scalars(std::vector<PointState> const& states, double PointState::*member) {
  std::vector<float> numbers;
  numbers.reserve(states.size());
  for (PointState const& state : states) numbers.push_back(static_cast<float>(state.*member));
  return numbers;
}

Blocks blocks_of(std::vector<PointState> const& states) {
  Blocks blocks;
  blocks.add("Float32", "pressure", "Pa", 1, scalars(states, &PointState::pressure));
  blocks.add("Float32", "density", "kg/m^3", 1, scalars(states, &PointState::density));
  blocks.add("Float32", "specific_energy", "J/kg", 1,
             scalars(states, &PointState::specific_energy));
  std::vector<float> velocities;
  std::vector<std::uint8_t> valid;
  for (PointState const& state : states) {
    for (double const v : state.velocity) velocities.push_back(static_cast<float>(v));
    valid.push_back(std::isnan(state.pressure) ? 0 : 1);
  }
  blocks.add("Float32", "velocity", "m/s", 3, velocities);
  blocks.add("UInt8", "valid", "", 1, valid);
  return blocks;
}

}  // namespace

void write_vti(std::filesystem::path const& path, PlaceGrid const& grid,
               std::vector<PointState> const& states, double time) {
  std::string const extent =
      fmt::format("0 {} 0 {} 0 {}", grid.points[0] - 1, grid.points[1] - 1, grid.points[2] - 1);
  Blocks const blocks = blocks_of(states);
  AtomicFile file(path);
  file.stream() << fmt::format(file_head, extent, grid.origin[0], grid.origin[1], grid.origin[2],
                               grid.step[0], grid.step[1], grid.step[2], time)
                << blocks.head()
                << "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_"
                << blocks.data() << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

}  // namespace moraine
