#include "output/vtp_reader.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <stdexcept>

namespace moraine {
namespace {

/// The text before the binary block, closed so that it is well-formed, and the block itself.
class VtpFile {
 public:
  explicit VtpFile(std::filesystem::path const& path);

  pugi::xml_node piece() const { return poly_data().child("Piece"); }
  double field_value(char const* name, double missing) const;
  FrameArray array(pugi::xml_node node, std::size_t size) const;

  [[noreturn]] void refuse(std::string const& why) const {
    throw std::runtime_error(fmt::format("cannot read frame '{}': {}", path_.string(), why));
  }

 private:
  pugi::xml_node poly_data() const { return document_.child("VTKFile").child("PolyData"); }
  void check_dialect() const;

  std::filesystem::path path_;
  std::string bytes_;
  std::size_t data_ = 0;  // place of the byte behind the underscore
  pugi::xml_document document_;
};

VtpFile::VtpFile(std::filesystem::path const& path) : path_(path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse("no such file");
  bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  std::size_t const appended = bytes_.find("<AppendedData");
  std::size_t const underscore =
      appended == std::string::npos ? appended : bytes_.find('_', bytes_.find('>', appended));
  if (underscore == std::string::npos) refuse("no appended data");
  data_ = underscore + 1;
  pugi::xml_parse_result const result =
      document_.load_string((bytes_.substr(0, appended) + "</VTKFile>").c_str());
  if (!result) refuse(result.description());
  check_dialect();
}

void VtpFile::check_dialect() const {
  pugi::xml_node const root = document_.child("VTKFile");
  auto const require = [&](char const* attribute, std::string_view expected) {
    std::string_view const found = root.attribute(attribute).value();
    if (found != expected)
      refuse(fmt::format("{} is '{}', only '{}' is understood", attribute, found, expected));
  };
  require("type", "PolyData");
  require("byte_order", "LittleEndian");
  require("header_type", "UInt64");
  require("compressor", "");
  if (!piece() || piece().next_sibling("Piece")) refuse("not exactly one Piece");
}

double VtpFile::field_value(char const* name, double missing) const {
  pugi::xml_node const field_data = poly_data().child("FieldData");
  return field_data.find_child_by_attribute("DataArray", "Name", name).text().as_double(missing);
}

template <class T>
void convert(char const* from, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    T number;
    std::memcpy(&number, from + i * sizeof(T), sizeof(T));
    values[i] = static_cast<double>(number);
  }
}

struct NumberType {
  std::string_view name;
  std::size_t bytes;
  void (*convert)(char const*, std::vector<double>&);
};

constexpr NumberType number_types[] = {
    {"Float32", 4, convert<float>},      {"Float64", 8, convert<double>},
    {"UInt8", 1, convert<std::uint8_t>}, {"Int32", 4, convert<std::int32_t>},
    {"Int64", 8, convert<std::int64_t>}, {"UInt64", 8, convert<std::uint64_t>},
};

FrameArray VtpFile::array(pugi::xml_node node, std::size_t size) const {
  FrameArray array;
  array.name = node.attribute("Name").value();
  array.unit = node.find_child_by_attribute("InformationKey", "name", "UNITS_LABEL").text().get();
  array.components = node.attribute("NumberOfComponents").as_uint(1);
  if (std::string_view(node.attribute("format").value()) != "appended")
    refuse(fmt::format("array '{}' is not appended", array.name));

  // Any more would exceed the file, and overflow what is computed below.
  if (array.components == 0 || array.components > bytes_.size() ||
      size > bytes_.size() / array.components)
    refuse(fmt::format("array '{}' has {} components of {} particles, more than fit into the file",
                       array.name, array.components, size));
  std::string_view const type_name = node.attribute("type").value();
  for (NumberType const& type : number_types) {
    if (type.name != type_name) continue;
    std::size_t const offset = node.attribute("offset").as_ullong();
    std::uint64_t bytes = 0;
    std::size_t const behind = bytes_.size() - data_;
    if (behind < sizeof bytes || offset > behind - sizeof bytes) refuse("the file is cut off");
    std::size_t const start = data_ + offset;
    std::memcpy(&bytes, bytes_.data() + start, sizeof bytes);
    if (bytes != size * array.components * type.bytes)
      refuse(fmt::format("array '{}' has {} bytes where {} particles need {}", array.name, bytes,
                         size, size * array.components * type.bytes));
    if (bytes > bytes_.size() - start - sizeof bytes) refuse("the file is cut off");
    array.values.resize(size * array.components);
    type.convert(bytes_.data() + start + sizeof bytes, array.values);
    return array;
  }
  refuse(fmt::format("array '{}' has the unknown type '{}'", array.name, type_name));
}

}  // namespace

FrameArray const* ParticleFrame::find(std::string_view name) const {
  for (FrameArray const& array : arrays)
    if (array.name == name) return &array;
  return nullptr;
}

ParticleFrame read_vtp(std::filesystem::path const& path) {
  VtpFile const file(path);
  ParticleFrame frame;
  frame.time = file.field_value("TimeValue", 0.0);
  double const dimension = file.field_value("dimension", 3.0);
  if (dimension != 1.0 && dimension != 2.0 && dimension != 3.0)
    file.refuse(fmt::format("dimension is {}, only 1, 2 and 3 are understood", dimension));
  frame.dimension = static_cast<int>(dimension);
  frame.size = file.piece().attribute("NumberOfPoints").as_ullong();
  frame.points = file.array(file.piece().child("Points").child("DataArray"), frame.size);
  if (frame.points.components != 3) file.refuse("points do not have three components");
  for (pugi::xml_node const node : file.piece().child("PointData").children("DataArray"))
    frame.arrays.push_back(file.array(node, frame.size));
  return frame;
}

}  // namespace moraine
