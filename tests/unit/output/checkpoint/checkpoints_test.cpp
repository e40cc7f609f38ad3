#include "output/checkpoint/checkpoints.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>
#include <random>
#include <stdexcept>

#include "output/atomic_file.hpp"
#include "output/checkpoint/seal.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

/// One piece of state of every type.
struct State {
  double length = 0.0;
  std::uint64_t count = 0;
  std::string name;
  std::vector<double> numbers;
  std::vector<std::uint64_t> ids;
  std::vector<std::uint32_t> indices;
  std::vector<std::int32_t> units;
  std::vector<std::uint8_t> bytes;

  void exchange(Archive& archive) {
    archive.number("length", length);
    archive.number("group/count", count);
    archive.text("group/name", name);
    archive.array("deep/er/numbers", "kg/m^3", numbers);
    archive.array("ids", "", ids);
    archive.array("indices", "", indices);
    archive.array("units", "", units);
    archive.array("bytes", "", bytes);
  }
  bool operator==(State const&) const = default;
};

State some_state() {
  return {0.1,
          std::numeric_limits<std::uint64_t>::max(),
          "wall \"1\"",
          {1.0 / 3.0, -0.0, 1e-310, std::numeric_limits<double>::infinity()},
          {1, std::uint64_t{1} << 63},
          {0xFFFFFFFFu},
          {std::numeric_limits<std::int32_t>::min(), 7},
          {0, 255}};
}

class CheckpointsTest : public ScratchFolder {
 protected:
  static Exchange of(State& state) {
    return [&](Archive& archive) { state.exchange(archive); };
  }
  /// The newest whole state, restored.
  State newest(Checkpoints const& checkpoints, std::size_t expected_skipped = 0) {
    std::vector<std::string> skipped;
    auto const file = checkpoints.newest(skipped);
    EXPECT_EQ(skipped.size(), expected_skipped);
    State state;
    if (file)
      restore_hdf5(*file, of(state));
    else
      ADD_FAILURE() << "no checkpoint";
    return state;
  }
  void flip(std::filesystem::path const& file, std::size_t place) {
    std::string bytes = bytes_of(file);
    bytes[place] = static_cast<char>(bytes[place] ^ 1);
    write(file, bytes);
  }
  std::filesystem::path file_of(int step) const {
    return path(fmt::format("checkpoints/step_{:012}.h5", step));
  }
};

TEST_F(CheckpointsTest, BringBackEveryBit) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  checkpoints.save(7, of(state));
  EXPECT_EQ(newest(checkpoints), state);
}

TEST_F(CheckpointsTest, EmptyArraysToo) {
  State state;
  Checkpoints checkpoints(path(""));
  checkpoints.save(7, of(state));
  EXPECT_EQ(newest(checkpoints), state);
}

TEST_F(CheckpointsTest, KeepTheTwoNewest) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  for (int const step : {1, 20, 300}) {
    state.count = static_cast<std::uint64_t>(step);
    checkpoints.save(state.count, of(state));
  }
  EXPECT_FALSE(std::filesystem::exists(file_of(1)));
  EXPECT_TRUE(std::filesystem::exists(file_of(20)));
  EXPECT_EQ(newest(checkpoints).count, 300U);
}

TEST_F(CheckpointsTest, PassOverADamagedOne) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  state.count = 1;
  checkpoints.save(1, of(state));
  state.count = 2;
  checkpoints.save(2, of(state));
  flip(file_of(2), 3000);
  EXPECT_EQ(newest(checkpoints, 1).count, 1U);
  write(file_of(2), "");
  EXPECT_EQ(newest(checkpoints, 1).count, 1U);
  write(path("checkpoints/step_000000000003.h5.tmp"), "unfinished");
  EXPECT_EQ(newest(checkpoints, 1).count, 1U);
}

TEST_F(CheckpointsTest, ShowAnyChangedByte) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  checkpoints.save(1, of(state));
  auto const file = file_of(1);
  std::string const good = bytes_of(file);
  ASSERT_EQ(broken_seal(file), "");
  std::mt19937 random(1);
  auto const refused = [&](std::size_t place) {
    std::string bytes = good;
    bytes[place] = static_cast<char>(bytes[place] ^ (1 + random() % 255));
    write(file, bytes);
    return !broken_seal(file).empty();
  };
  // Every byte of the seal, every 37th of the rest.
  for (std::size_t place = 0; place < good.size(); place += place < seal_size ? 1 : 37)
    EXPECT_TRUE(refused(place)) << "byte " << place;
  write(file, good.substr(0, good.size() - 1));
  EXPECT_NE(broken_seal(file), "");
  write(file, good + '\0');
  EXPECT_NE(broken_seal(file), "");
}

TEST_F(CheckpointsTest, ForgetWhatIsNewer) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  checkpoints.save(1, of(state));
  checkpoints.save(2, of(state));
  write(file_of(3), "damaged");
  write(path("checkpoints/step_000000000003.h5.tmp"), "unfinished");
  write(path("checkpoints/notes.txt"), "mine");
  checkpoints.forget_newer(file_of(2));
  EXPECT_TRUE(std::filesystem::exists(file_of(1)));
  EXPECT_TRUE(std::filesystem::exists(file_of(2)));
  EXPECT_FALSE(std::filesystem::exists(file_of(3)));
  EXPECT_FALSE(std::filesystem::exists(path("checkpoints/step_000000000003.h5.tmp")));
  EXPECT_TRUE(std::filesystem::exists(path("checkpoints/notes.txt")));
  checkpoints.forget();
  EXPECT_FALSE(std::filesystem::exists(file_of(1)));
  EXPECT_TRUE(std::filesystem::exists(path("checkpoints/notes.txt")));
}

TEST_F(CheckpointsTest, NameThePieceThatIsMissingOrOfAnotherType) {
  State state = some_state();
  auto const file = path("state.h5");
  with_hdf5_image(of(state), [&](FileImage image) { write_file(file, image); });
  auto const message = [&](Exchange const& exchange) {
    return message_of<std::runtime_error>([&] { restore_hdf5(file, exchange); });
  };
  double number = 0.0;
  EXPECT_NE(message([&](Archive& archive) {
              archive.number("width", number);
            }).find("state.h5: width is missing"),
            std::string::npos);
  EXPECT_NE(message([&](Archive& archive) {
              archive.number("ids", number);
            }).find("ids has another type"),
            std::string::npos);
  EXPECT_NE(message([&](Archive& archive) {
              archive.number("deep/er/numbers", number);
            }).find("is not one number"),
            std::string::npos);
}

// A limit on the size of files stands for a full disk: writing fails at some byte.
TEST_F(CheckpointsTest, AFullDiskLeavesTheOlderStates) {
  State state = some_state();
  Checkpoints checkpoints(path(""));
  state.count = 1;
  checkpoints.save(1, of(state));
  state.numbers.assign(100000, 1.5);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  auto const handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit const small{100000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string const message =
      message_of<std::runtime_error>([&] { checkpoints.save(2, of(state)); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("no checkpoint of step 2"), std::string::npos) << message;
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(newest(checkpoints).count, 1U);
  EXPECT_FALSE(std::filesystem::exists(path("checkpoints/step_000000000002.h5.tmp")));
}

}  // namespace
}  // namespace moraine
