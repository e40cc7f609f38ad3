// A small sealed checkpoint with any byte changed, or cut off anywhere, is refused with a
// reason.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "output/checkpoint/hdf5_archive.hpp"
#include "output/checkpoint/seal.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class DamagedCheckpoint : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    std::vector<double> numbers(300, 1.0 / 3.0);
    std::string text = "a case";
    with_hdf5_image(
        [&](Archive& archive) {
          archive.array("particles/density", "kg/m^3", numbers);
          archive.text("case", text);
        },
        [&](FileImage image) {
          seal(image);
          good_.assign(image.begin(), image.end());
        });
    ASSERT_EQ(reason(good_), "");
  }
  /// Why these bytes are no checkpoint.
  std::string reason(std::string const& bytes) const {
    write(path("state.h5"), bytes);
    return broken_seal(path("state.h5"));
  }
  /// Why the checkpoint is none with one byte changed. Changed in its place: rewriting the file for
  /// each byte would take a minute.
  std::string reason_with(std::size_t place, int change) const {
    auto const put = [&](char byte) {
      std::fstream file(path("state.h5"), std::ios::binary | std::ios::in | std::ios::out);
      file.seekp(static_cast<std::streamoff>(place));
      file.put(byte);
    };
    put(static_cast<char>(good_[place] ^ change));
    std::string why = broken_seal(path("state.h5"));
    put(good_[place]);
    return why;
  }
  std::string good_;
};

TEST_F(DamagedCheckpoint, AnyBitOfTheSealShows) {
  std::string const damaged = "is damaged: its checksum does not fit its content";
  std::string const other = "is not a checkpoint";
  std::size_t const name = std::string("moraine checkpoint, ").size();
  for (std::size_t place = 0; place < seal_size; ++place)
    for (int bit = 0; bit < 8; ++bit)
      ASSERT_EQ(reason_with(place, 1 << bit), place < name ? other : damaged) << "byte " << place;
}

TEST_F(DamagedCheckpoint, AnyByteOfTheContentShows) {
  std::mt19937_64 random(20240117);
  for (std::size_t place = seal_size; place < good_.size(); ++place)
    ASSERT_EQ(reason_with(place, 1 + static_cast<int>(random() % 255)),
              "is damaged: its checksum does not fit its content")
        << place;
  EXPECT_EQ(broken_seal(path("state.h5")), "") << "it was whole between the changes";
}

TEST_F(DamagedCheckpoint, AnyOtherLengthShows) {
  for (std::size_t length = 0; length < good_.size(); length += length < seal_size + 8 ? 17 : 61)
    EXPECT_EQ(
        reason(good_.substr(0, length)),
        length < seal_size ? "is cut off" : "is damaged: its checksum does not fit its content")
        << length;
  EXPECT_NE(reason(good_.substr(0, good_.size() - 1)), "");
  EXPECT_NE(reason(good_ + '\0'), "");
}

}  // namespace
}  // namespace moraine
