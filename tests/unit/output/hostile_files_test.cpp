// Files of a run folder that nobody in their right mind writes: found by the fuzz targets.
#include <gtest/gtest.h>

#include <stdexcept>

#include "output/plot/axis.hpp"
#include "output/plot/drawable.hpp"
#include "output/plot/plot.hpp"
#include "output/run_folder.hpp"
#include "output/vtp_reader.hpp"
#include "output/vtp_writer.hpp"
#include "scratch_folder.hpp"

namespace moraine {
namespace {

class HostileFiles : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    ParticleStore store(2);
    for (int i = 0; i < 3; ++i) store.append(Kind::fluid, 0);
    write_vtp(path("good.vtp"), store, Kind::fluid, 0.0);
  }
  /// What the reader says about a frame with a text replaced, at its last place.
  std::string refusal(std::string const& from, std::string const& to) const {
    std::string bytes = bytes_of(path("good.vtp"));
    std::size_t const place = bytes.rfind(from);
    EXPECT_NE(place, std::string::npos) << from;
    write(path("bad.vtp"), bytes.replace(place, from.size(), to));
    return message_of<std::runtime_error>([&] { read_vtp(path("bad.vtp")); });
  }
};

TEST_F(HostileFiles, FramesWhoseSizesOverflow) {
  // 2^61 particles of 8 bytes are 2^64 bytes: none, in 64 bits.
  for (char const* size : {"2305843009213693952", "18446744073709551615", "6148914691236517206"})
    EXPECT_NE(refusal("NumberOfPoints=\"3\"", "NumberOfPoints=\"" + std::string(size) + "\"")
                  .find("more than fit into the file"),
              std::string::npos)
        << size;
  EXPECT_NE(refusal("NumberOfComponents=\"3\"", "NumberOfComponents=\"0\"").find("0 components"),
            std::string::npos);
}

TEST_F(HostileFiles, FramesWhoseOffsetsOverflow) {
  for (char const* offset : {"18446744073709551615", "18446744073709551600", "99999999"})
    EXPECT_NE(refusal("offset=\"0\"", "offset=\"" + std::string(offset) + "\"").find("cut off"),
              std::string::npos)
        << offset;
}

TEST_F(HostileFiles, FramesOfOtherDimensions) {
  for (char const* dimension : {"0", "4", "1e300", "-1", "2.5"})
    EXPECT_NE(refusal("ascii\">2</DataArray>", "ascii\">" + std::string(dimension) + "</DataArray>")
                  .find("dimension is"),
              std::string::npos)
        << dimension;
}

// Steps between ticks would not change the value, without end.
TEST_F(HostileFiles, TicksWhereNumbersHaveNoMoreDigits) {
  for (auto const& [low, high] : {std::pair(1e16, 1e16 + 4.0), std::pair(-1.7e308, 1.7e308),
                                  std::pair(0.0, 5e-324), std::pair(1.0, 1.0 + 1e-15)})
    EXPECT_LE(plot::round_ticks(low, high, 7).values.size(), 8U) << low;
  EXPECT_EQ(plot::round_ticks(1.0, 1.0 + 1e-6, 7).values.size(), 6U) << "still told apart";
}

TEST_F(HostileFiles, TablesOfExtremeNumbersAreDrawn) {
  write(path("a.csv"), "time [s],a [Pa],b [m]\n0,1e308,-1e308\n1e300,-1e308,5e-324\n2e308,nan,1\n");
  EXPECT_NE(message_of<std::runtime_error>([&] { read_table_csv(path("a.csv")); }).find(":4:"),
            std::string::npos)
      << "2e308 is no double";
  write(path("a.csv"), "time [s],a [Pa],b [m]\n0,1e308,-1e308\n1e300,-1e308,5e-324\n1,nan,1e99\n");
  plot_histories(path("a.csv"), path("a.svg"));
  std::string const picture = bytes_of(path("a.svg"));
  EXPECT_EQ(picture.find("nan"), std::string::npos);
  EXPECT_EQ(picture.find("inf"), std::string::npos);
}

TEST_F(HostileFiles, ParticlesFarFromTheOriginAreDrawn) {
  ParticleStore store(2);
  std::size_t const i = store.append(Kind::fluid, 0);
  for (int axis = 0; axis < 2; ++axis) store.component(Field::position, axis)[i] = 2.8e20;
  write_vtp(path("far.vtp"), store, Kind::fluid, 0.0);
  plot_frame(path("far.vtp"), "pressure", path("far.svg"), {});
  EXPECT_NE(bytes_of(path("far.svg")).find("</svg>"), std::string::npos);
}

TEST_F(HostileFiles, ManifestsOfOtherShapesAreNoEnd) {
  for (char const* text :
       {"", "[]", "3", R"({"state": 3})", R"({"state": {}})", R"({"state": "x"})"}) {
    write(path("manifest.json"), text);
    EXPECT_FALSE(has_written_its_end(path(""))) << text;
  }
  write(path("manifest.json"), R"({"state": "ended"})");
  EXPECT_TRUE(has_written_its_end(path("")));
}

}  // namespace
}  // namespace moraine
