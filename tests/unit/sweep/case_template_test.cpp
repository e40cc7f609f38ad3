#include "sweep/case_template.hpp"

#include <gtest/gtest.h>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "support/bodies.hpp"
#include "unit/output/scratch_folder.hpp"
#include "unit/sweep/sample_case.hpp"

namespace moraine {
namespace {

class CaseTemplates : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("sample.toml"), sample_case);
  }
  static Replacement replacement(CaseTemplate const& cases, std::string const& key,
                                 std::string const& value) {
    return {std::get<CaseKey>(find_key(key, cases.base())), value};
  }
};

TEST_F(CaseTemplates, WithoutReplacementsAreTheSameCase) {
  CaseTemplate const cases(path("sample.toml"));
  EXPECT_EQ(used_case(cases.with({})), used_case(cases.base()));
  write(path("copy.toml"), cases.text({}, path("")));
  Case const copy = read_case(path("copy.toml"));
  EXPECT_EQ(used_case(copy), used_case(cases.base()));
  EXPECT_EQ(copy.materials.front().name, "water") << "in the order of the file";
}

TEST_F(CaseTemplates, ReplaceKeysThatAreThereAndThatAreNot) {
  CaseTemplate const cases(path("sample.toml"));
  Case const c = cases.with(
      std::vector<Replacement>{replacement(cases, "resolution.spacing", "\"2 cm\""),
                               replacement(cases, "resolution.kernel", "\"cubic_spline\""),
                               replacement(cases, "numerics.precision", "\"double\""),
                               replacement(cases, "material.gas.heat_capacity_ratio", "1.6"),
                               replacement(cases, "region.bubble.disc.radius", "0.03"),
                               replacement(cases, "gauge.1.5 cm.position", "[0.1, \"20 cm\"]"),
                               replacement(cases, "resolution.smoothing.mode", "\"density\"")});
  EXPECT_EQ(c.numerics.spacing, 0.02);
  EXPECT_EQ(c.numerics.kernel, KernelName::cubic_spline);
  EXPECT_EQ(std::get<Disc>(c.regions[1].shape).radius, 0.03);
  EXPECT_EQ(c.gauges[0].position[1], 0.2);
  EXPECT_NE(used_case(c).find("heat_capacity_ratio = 1.6"), std::string::npos);
  EXPECT_NE(used_case(c).find("precision = \"double\""), std::string::npos);
  EXPECT_NE(used_case(c).find("smoothing.mode = \"density\""), std::string::npos);
}

TEST_F(CaseTemplates, MistakesOfACaseComeOut) {
  CaseTemplate const cases(path("sample.toml"));
  std::vector<Replacement> const wrong{replacement(cases, "gauge.1.position", "[\"1 km\", 0.0]")};
  EXPECT_THROW(cases.with(wrong), InputErrors);
}

TEST_F(CaseTemplates, FilesAreFoundFromAnotherFolder) {
  std::filesystem::create_directories(path("data"));
  write(path("data/sway.csv"), "time,x\n0,0\n1,0\n2,0.1\n3,0\n");
  std::string text = sample_case;
  text.replace(text.find("container"), 0, "motion = { file = \"data/sway.csv\" }\n");
  write(path("moved.toml"), text);
  CaseTemplate const cases(path("moved.toml"));
  auto const folder = path("out/members/001");
  std::filesystem::create_directories(folder);
  std::string const member = cases.text({}, folder);
  write(folder / "case.toml", member);
  Case const c = read_case(folder / "case.toml");
  EXPECT_NE(used_case(c).find("data/sway.csv"), std::string::npos);
  EXPECT_NE(member.find("file = \"../../../data/sway.csv\""), std::string::npos) << member;
  write(path("data/sway.csv"), "time,x\n0,0\n1,0\n2,0.2\n3,0\n");
  EXPECT_NE(cases.text({}, folder), member) << "another file makes another case";
}

TEST_F(CaseTemplates, BodiesAreFoundWhereverTheyStand) {
  write(path("cube.stl"), stl_text(cube({0.0, 0.0, 0.0}, 0.4)));
  write(path("body.toml"), R"(space = { dimension = 3 }
resolution.spacing = 0.1
time = { end = "1 s" }
material.water = { eos = "tait", reference_sound_speed = 20.0 }
[[region]]
name = "sea"
material = "water"
box = { min = [0, 0, 0], max = [1, 1, 1] }
plus = [{ disc = { center = [1, 1, 1], radius = 0.3 }, minus = [{ stl = { file = "cube.stl", units = "m" } }] }]
[[region]]
name = "block"
material = "water"
[region.stl]
file = "cube.stl"
units = "m"
)");
  CaseTemplate const cases(path("body.toml"));
  auto const folder = path("out/members/001");
  std::string const member = cases.text({}, folder);
  std::filesystem::create_directories(folder);
  write(folder / "case.toml", member);
  EXPECT_EQ(read_case(folder / "case.toml").regions.size(), 2U);
  auto const first = member.find("file = \"../../../cube.stl\"");
  EXPECT_NE(member.find("file = \"../../../cube.stl\"", first + 1), std::string::npos) << member;
}

}  // namespace
}  // namespace moraine
