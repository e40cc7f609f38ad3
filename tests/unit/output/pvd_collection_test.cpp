#include "output/pvd_collection.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scratch_folder.hpp"

namespace moraine {
namespace {

using PvdCollectionTest = ScratchFolder;

TEST_F(PvdCollectionTest, IsCompleteAfterEveryFrame) {
  PvdCollection collection(path("particles.pvd"));
  for (int i = 0; i < 3; ++i) {
    collection.add(i / 3.0, "frames/a & b " + std::to_string(i) + ".vtp");
    auto const entries = read_pvd(path("particles.pvd"));
    ASSERT_EQ(entries.size(), static_cast<std::size_t>(i) + 1);
    EXPECT_EQ(entries.back().time, i / 3.0);
    EXPECT_EQ(entries.back().file, "frames/a & b " + std::to_string(i) + ".vtp");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), {}), 1)
      << "nothing temporary is left";
}

TEST_F(PvdCollectionTest, GoesOnFromEarlierFrames) {
  PvdCollection(path("a.pvd")).add(0.0, "0.vtp");
  PvdCollection(path("a.pvd"), read_pvd(path("a.pvd"))).add(1.0, "1.vtp");
  EXPECT_EQ(read_pvd(path("a.pvd")).size(), 2U);
}

TEST_F(PvdCollectionTest, ErrorsNameTheFile) {
  auto const none = message_of<std::runtime_error>([&] { read_pvd(path("none.pvd")); });
  EXPECT_NE(none.find("none.pvd"), std::string::npos) << none;
  write(path("other.pvd"), "<VTKFile/>");
  auto const other = message_of<std::runtime_error>([&] { read_pvd(path("other.pvd")); });
  EXPECT_NE(other.find("is not a .pvd collection"), std::string::npos) << other;
}

}  // namespace
}  // namespace moraine
