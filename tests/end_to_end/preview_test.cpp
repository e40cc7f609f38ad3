// `moraine preview`: files and counts, without a run.
#include <gtest/gtest.h>

#include <string>

#include "end_to_end/small_case.hpp"
#include "output/vtp_reader.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class PreviewCommand : public ScratchFolder {};

TEST_F(PreviewCommand, WritesWhatTheCaseHolds) {
  write(path("case.toml"), small_case());
  auto const result = moraine_command(path(""), {"preview", "case.toml", "-o", "look"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "region column: 150 particles, 60 kg/m");
  ParticleFrame const frame = read_vtp(path("look/particles.vtp"));
  EXPECT_EQ(frame.size, 150U);
  ASSERT_NE(frame.find("pressure"), nullptr);
  EXPECT_GT(read_vtp(path("look/walls.vtp")).size, 0U);
  ParticleFrame const probes = read_vtp(path("look/probes.vtp"));
  ASSERT_EQ(probes.size, 1U);
  EXPECT_NEAR(probes.points.values[0], 0.02, 1e-8);  // single precision
  EXPECT_EQ(bytes_of(path("look/preview.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_FALSE(std::filesystem::exists(path("look/manifest.json"))) << "nothing ran";
}

TEST_F(PreviewCommand, CountsWhatIsReplaced) {
  write(path("case.toml"), small_case() +
                               "[[region]]\nname = \"plug\"\nmaterial = \"water\"\n"
                               "box = { min = [0.0, 0.0], max = [0.1, 0.1] }\n");
  auto const result = moraine_command(path(""), {"preview", "case.toml", "-o", "look"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("region column: 125 particles, 50 kg/m, 25 more replaced by later "
                            "regions\nregion plug: 25 particles, 10 kg/m\n"),
            std::string::npos)
      << result.out;
}

TEST_F(PreviewCommand, LeavesTheResultsOfARunAlone) {
  write(path("case.toml"), small_case());
  std::filesystem::create_directories(path("run"));
  write(path("run/manifest.json"), "{}");
  auto const result = moraine_command(path(""), {"preview", "case.toml", "-o", "run"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine preview: --output: \"run\" holds the results of a run; choose another folder "
            "with --output\n");
  EXPECT_FALSE(std::filesystem::exists(path("run/particles.vtp")));
}

}  // namespace
}  // namespace moraine
