#include "output/vtp_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "output/atomic_file.hpp"
#include "probes/solid_state.hpp"

namespace moraine {
namespace {

static_assert(std::endian::native == std::endian::little, "blocks are copies of memory");

constexpr Field written_fields[] = {Field::velocity,        Field::density,     Field::pressure,
                                    Field::specific_energy, Field::sound_speed, Field::mass};

constexpr char unit_key[] =
    R"(><InformationKey name="UNITS_LABEL" location="vtkDataArray">{}</InformationKey></DataArray>
)";

constexpr char file_head[] = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<FieldData>
<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">{}</DataArray>
<DataArray type="Int32" Name="dimension" NumberOfTuples="1" format="ascii">{}</DataArray>
</FieldData>
<Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="0" NumberOfStrips="0"
 NumberOfPolys="0">
<PointData Scalars="pressure" Vectors="velocity">
)";

/// One array of the file: what the header says about it, and how to write its numbers.
struct Block {
  std::string_view type;
  std::string name;
  std::string unit;
  int components;
  std::uint64_t bytes;
  std::function<void(std::ostream&)> write;
};

template <class T>
void write_numbers(std::ostream& stream, std::vector<T> const& numbers) {
  stream.write(reinterpret_cast<char const*>(numbers.data()),
               static_cast<std::streamsize>(numbers.size() * sizeof(T)));
}

class FrameWriter {
 public:
  FrameWriter(ParticleStore const& store, Kind kind, std::vector<ParticleArray> const& more)
      : store_(store), kind_(kind), range_(store.range(kind)), more_(more) {}

  void write(std::ostream& stream, double time);

 private:
  Block field_block(Field field) const;
  Block stress_block() const;
  Block shear_block() const;
  template <class T, class Value>
  Block block(std::string_view type, std::string name, Value value) const;
  std::string declare(Block const& block);

  ParticleStore const& store_;
  Kind kind_;
  Range range_;
  std::vector<ParticleArray> const& more_;
  std::uint64_t offset_ = 0;  // of the next block, counted from behind the underscore
};

Block FrameWriter::field_block(Field field) const {
  FieldInfo const& about = info(field);
  int const components = moraine::components(about.rank, 3);
  int const stored = moraine::components(about.rank, store_.dimension());
  auto const stride = static_cast<std::size_t>(components);
  auto const write = [this, field, stored, stride](std::ostream& stream) {
    std::vector<float> numbers(range_.size() * stride);
    for (int axis = 0; axis < stored; ++axis) {
      auto const all = store_.component(field, axis);
      if (all.size() < range_.end) continue;  // walls do not have this field: zero
      auto const from = all.subspan(range_.begin, range_.size());
      for (std::size_t i = 0; i < from.size(); ++i)
        numbers[i * stride + static_cast<std::size_t>(axis)] = static_cast<float>(from[i]);
    }
    write_numbers(stream, numbers);
  };
  return {"Float32",
          std::string(about.name),
          std::string(about.unit),
          components,
          range_.size() * stride * sizeof(float),
          write};
}

template <class T, class Value>
Block FrameWriter::block(std::string_view type, std::string name, Value value) const {
  auto const write = [this, value](std::ostream& stream) {
    std::vector<T> numbers(range_.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = value(i);
    write_numbers(stream, numbers);
  };
  return {type, std::move(name), "", 1, range_.size() * sizeof(T), write};
}

/// sigma = s - p 1, as ParaView orders a symmetric tensor: xx, yy, zz, xy, yz, xz.
Block FrameWriter::stress_block() const {
  auto const write = [this](std::ostream& stream) {
    auto const pressure = store_.scalar(Field::pressure);
    std::vector<float> numbers;
    numbers.reserve(6 * range_.size());
    for (std::size_t i = range_.begin; i < range_.end; ++i) {
      Deviator const s = deviator_of(store_, i);
      double const p = pressure[i];
      for (double const value : {s[0] - p, s[1] - p, s[2] - p, s[3], s[5], s[4]})
        numbers.push_back(static_cast<float>(value));
    }
    write_numbers(stream, numbers);
  };
  return {"Float32", "stress", "Pa", 6, 6 * range_.size() * sizeof(float), write};
}

/// sqrt(J2).
Block FrameWriter::shear_block() const {
  Block made = block<float>("Float32", "shear_stress", [this](std::size_t i) {
    return static_cast<float>(shear_norm(deviator_of(store_, range_.begin + i)));
  });
  made.unit = "Pa";
  return made;
}

std::string FrameWriter::declare(Block const& block) {
  std::string text = fmt::format(
      R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}")",
      block.type, block.name, block.components, offset_);
  offset_ += sizeof(std::uint64_t) + block.bytes;
  if (block.unit.empty()) return text + "/>\n";
  return text + fmt::format(unit_key, block.unit);
}

void FrameWriter::write(std::ostream& stream, double time) {
  std::vector<Block> blocks;
  blocks.push_back(field_block(Field::position));
  for (Field const field : written_fields) blocks.push_back(field_block(field));
  for (Field const field : {Field::burn_fraction, Field::distension, Field::smoothing_length,
                            Field::plastic_strain, Field::plastic_work, Field::spalled})
    if (kind_ == Kind::fluid && store_.has(field)) blocks.push_back(field_block(field));
  if (kind_ == Kind::fluid && store_.has(Field::deviatoric_stress)) {
    blocks.push_back(stress_block());
    blocks.push_back(shear_block());
  }
  std::size_t const first = range_.begin;
  for (ParticleArray const& array : more_) {
    blocks.push_back(block<float>("Float32", array.name, [this, first, &array](std::size_t i) {
      return static_cast<float>(array.by_id[store_.id()[first + i]]);
    }));
    blocks.back().unit = array.unit;
  }
  blocks.push_back(block<std::uint8_t>(
      "UInt8", "material", [this, first](std::size_t i) { return store_.material()[first + i]; }));
  blocks.push_back(block<std::uint8_t>(
      "UInt8", "kind", [this](std::size_t) { return static_cast<std::uint8_t>(kind_); }));
  blocks.push_back(block<std::uint64_t>(
      "UInt64", "id", [this, first](std::size_t i) { return store_.id()[first + i]; }));
  blocks.push_back(block<std::int64_t>("Int64", "connectivity",
                                       [](std::size_t i) { return static_cast<std::int64_t>(i); }));
  blocks.push_back(block<std::int64_t>(
      "Int64", "offsets", [](std::size_t i) { return static_cast<std::int64_t>(i + 1); }));

  std::string point_data;
  std::string const points = declare(blocks.front());
  for (std::size_t i = 1; i + 2 < blocks.size(); ++i) point_data += declare(blocks[i]);
  std::string const connectivity = declare(blocks[blocks.size() - 2]);
  std::string const offsets = declare(blocks.back());

  stream << fmt::format(file_head, time, store_.dimension(), range_.size(), range_.size())
         << point_data << "</PointData>\n<Points>\n"
         << points << "</Points>\n<Verts>\n"
         << connectivity << offsets
         << "</Verts>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  for (Block const& block : blocks) {
    stream.write(reinterpret_cast<char const*>(&block.bytes), sizeof block.bytes);
    block.write(stream);
  }
  stream << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace

void write_vtp(std::filesystem::path const& path, ParticleStore const& store, Kind kind,
               double time, std::vector<ParticleArray> const& more) {
  AtomicFile file(path);
  FrameWriter(store, kind, more).write(file.stream(), time);
  file.commit();
}

}  // namespace moraine
