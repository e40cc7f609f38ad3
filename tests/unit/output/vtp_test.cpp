#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "output/vtp_reader.hpp"
#include "output/vtp_writer.hpp"
#include "scratch_folder.hpp"

namespace moraine {
namespace {

using VtpTest = ScratchFolder;

/// Three fluid and two wall particles in 2D whose numbers are all different and exact in float.
ParticleStore small_store() {
  ParticleStore store(2);
  for (int i = 0; i < 5; ++i) {
    std::size_t const p = i < 3 ? store.append(Kind::fluid, static_cast<MaterialId>(i))
                                : store.append(Kind::wall, no_material);
    store.component(Field::position, 0)[p] = 0.5 + i;
    store.component(Field::position, 1)[p] = -0.25 * i;
    store.scalar(Field::density)[p] = 1000.0 + i;
    store.scalar(Field::pressure)[p] = 65536.0 * (i + 1);
    store.scalar(Field::sound_speed)[p] = 1500.0 + i;
    if (i >= 3) continue;  // walls have no velocity, energy and mass
    store.component(Field::velocity, 0)[p] = 10.0 + i;
    store.component(Field::velocity, 1)[p] = 20.0 + i;
    store.scalar(Field::specific_energy)[p] = 300.0 + i;
    store.scalar(Field::mass)[p] = 2.0 + i;
  }
  return store;
}

/// Finds offset="..." of the array with this name by plain text search.
std::size_t offset_of(std::string const& bytes, std::string const& name) {
  std::size_t const at = bytes.find("Name=\"" + name + "\"");
  EXPECT_NE(at, std::string::npos) << name;
  std::size_t const offset = bytes.find("offset=\"", at) + 8;
  return std::stoul(bytes.substr(offset));
}

/// Block at an offset behind the underscore: eight bytes of length, then the numbers.
template <class T>
std::vector<T> block_at(std::string const& bytes, std::size_t offset) {
  std::size_t const start = bytes.find("<AppendedData encoding=\"raw\">\n_") + 31 + offset;
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < 8; ++i)
    length |= std::uint64_t{static_cast<unsigned char>(bytes[start + i])} << (8 * i);
  std::vector<T> numbers(length / sizeof(T));
  std::memcpy(numbers.data(), bytes.data() + start + 8, length);
  return numbers;
}

TEST_F(VtpTest, EveryBlockLiesWhereTheHeaderSays) {
  write_vtp(path("a.vtp"), small_store(), Kind::fluid, 0.0);
  std::string const bytes = bytes_of(path("a.vtp"));
  auto const block = [&]<class T>(T, char const* name) {
    return block_at<T>(bytes, offset_of(bytes, name));
  };
  using Floats = std::vector<float>;
  EXPECT_EQ(offset_of(bytes, "position"), 0U);
  EXPECT_EQ(offset_of(bytes, "velocity"), 8U + 3 * 3 * 4);
  EXPECT_EQ(block(float{}, "position"), (Floats{0.5F, 0, 0, 1.5F, -0.25F, 0, 2.5F, -0.5F, 0}));
  EXPECT_EQ(block(float{}, "velocity"), (Floats{10, 20, 0, 11, 21, 0, 12, 22, 0}));
  EXPECT_EQ(block(float{}, "density"), (Floats{1000, 1001, 1002}));
  EXPECT_EQ(block(float{}, "pressure"), (Floats{65536, 131072, 196608}));
  EXPECT_EQ(block(float{}, "specific_energy"), (Floats{300, 301, 302}));
  EXPECT_EQ(block(float{}, "sound_speed"), (Floats{1500, 1501, 1502}));
  EXPECT_EQ(block(float{}, "mass"), (Floats{2, 3, 4}));
  EXPECT_EQ(block(std::uint8_t{}, "material"), (std::vector<std::uint8_t>{0, 1, 2}));
  EXPECT_EQ(block(std::uint8_t{}, "kind"), (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(block(std::uint64_t{}, "id"), (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_EQ(block(std::int64_t{}, "connectivity"), (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(block(std::int64_t{}, "offsets"), (std::vector<std::int64_t>{1, 2, 3}));

  std::string const tail = "\n</AppendedData>\n</VTKFile>\n";
  std::size_t const last = bytes.find("\n_") + 2 + offset_of(bytes, "offsets") + 8 + 3 * 8;
  EXPECT_EQ(bytes.substr(last), tail);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), {}), 1)
      << "nothing temporary is left";
}

TEST_F(VtpTest, BurnFractionIsThereWhereSomethingBurns) {
  ParticleStore store = small_store();
  write_vtp(path("plain.vtp"), store, Kind::fluid, 0.0);
  EXPECT_EQ(read_vtp(path("plain.vtp")).find("burn_fraction"), nullptr);
  store.use(Field::burn_fraction);
  store.scalar(Field::burn_fraction)[1] = 0.25;
  write_vtp(path("burning.vtp"), store, Kind::fluid, 0.0);
  ParticleFrame const frame = read_vtp(path("burning.vtp"));
  ASSERT_NE(frame.find("burn_fraction"), nullptr);
  EXPECT_EQ(frame.find("burn_fraction")->values, (std::vector<double>{0, 0.25, 0}));
  write_vtp(path("walls.vtp"), store, Kind::wall, 0.0);
  EXPECT_EQ(read_vtp(path("walls.vtp")).find("burn_fraction"), nullptr);
}

TEST_F(VtpTest, HeaderNamesTheDialect) {
  write_vtp(path("a.vtp"), small_store(), Kind::wall, 0.125);
  std::string const bytes = bytes_of(path("a.vtp"));
  for (char const* part :
       {R"(type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64")",
        R"(Name="TimeValue" NumberOfTuples="1" format="ascii">0.125<)",
        R"(NumberOfPoints="2" NumberOfVerts="2")", R"(location="vtkDataArray">kg/m^3<)"})
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
}

TEST_F(VtpTest, ReaderGivesBackTheFrame) {
  write_vtp(path("walls.vtp"), small_store(), Kind::wall, 1.0 / 3.0);
  ParticleFrame const frame = read_vtp(path("walls.vtp"));
  EXPECT_EQ(frame.time, 1.0 / 3.0);
  EXPECT_EQ(frame.dimension, 2);
  EXPECT_EQ(frame.size, 2U);
  EXPECT_EQ(frame.points.values, (std::vector<double>{3.5, -0.75, 0, 4.5, -1, 0}));
  ASSERT_NE(frame.find("pressure"), nullptr);
  EXPECT_EQ(frame.find("pressure")->unit, "Pa");
  EXPECT_EQ(frame.find("pressure")->values, (std::vector<double>{262144, 327680}));
  EXPECT_EQ(frame.find("velocity")->components, 3U);
  EXPECT_EQ(frame.find("mass")->values, (std::vector<double>{0, 0})) << "walls have none";
  EXPECT_EQ(frame.find("kind")->values, (std::vector<double>{1, 1}));
  EXPECT_EQ(frame.find("material")->values, (std::vector<double>{255, 255}));
  EXPECT_EQ(frame.find("id")->values, (std::vector<double>{3, 4}));
  EXPECT_EQ(frame.find("colour"), nullptr);
}

TEST_F(VtpTest, EmptyFrameIsReadable) {
  write_vtp(path("a.vtp"), ParticleStore(3), Kind::fluid, 0.0);
  EXPECT_EQ(read_vtp(path("a.vtp")).size, 0U);
}

TEST_F(VtpTest, ReaderRefusesWhatItDoesNotUnderstand) {
  write_vtp(path("a.vtp"), small_store(), Kind::fluid, 0.0);
  std::string const good = bytes_of(path("a.vtp"));
  auto const message = [&](std::string const& bytes) {
    write(path("b.vtp"), bytes);
    return message_of<std::runtime_error>([&] { read_vtp(path("b.vtp")); });
  };
  auto const replaced = [&](std::string const& from, std::string const& to) {
    std::string bytes = good;
    return message(bytes.replace(bytes.find(from), from.size(), to));
  };
  EXPECT_EQ(message(good), "");
  EXPECT_NE(replaced("LittleEndian", "BigEndian").find("byte_order"), std::string::npos);
  EXPECT_NE(replaced("UInt64\"", "UInt32\"").find("header_type"), std::string::npos);
  EXPECT_NE(replaced("Float32", "Float16").find("Float16"), std::string::npos);
  EXPECT_NE(replaced("NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"").find("has 36 bytes"),
            std::string::npos);
  EXPECT_NE(message(good.substr(0, 100)).find("no appended data"), std::string::npos);
  EXPECT_NE(message(good.substr(0, good.find("\n_") + 60)).find("cut off"), std::string::npos);
}

/// VTK's own reader, where it is installed.
TEST_F(VtpTest, VtkReadsTheFrame) {
  if (std::system("/usr/bin/python3 -c 'import vtk' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no VTK for /usr/bin/python3 (Debian package python3-vtk9)";
  write_vtp(path("a.vtp"), small_store(), Kind::fluid, 0.125);
  write(path("check.py"), R"(import sys, vtk
reader = vtk.vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
frame = reader.GetOutput()
data = frame.GetPointData()
assert frame.GetNumberOfPoints() == 3 and frame.GetNumberOfVerts() == 3
assert frame.GetPoint(1) == (1.5, -0.25, 0.0), frame.GetPoint(1)
assert [data.GetArray('pressure').GetValue(i) for i in range(3)] == [65536, 131072, 196608]
assert data.GetArray('velocity').GetTuple3(2) == (12, 22, 0)
assert data.GetArray('id').GetValue(2) == 2
assert frame.GetFieldData().GetArray('TimeValue').GetValue(0) == 0.125
key = vtk.vtkDataArray.UNITS_LABEL()
assert data.GetArray('density').GetInformation().Get(key).strip() == 'kg/m^3'
)");
  std::string const command =
      "/usr/bin/python3 " + path("check.py").string() + " " + path("a.vtp").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace moraine
