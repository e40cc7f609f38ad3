#include "output/manifest.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/sha256.hpp"
#include "scratch_folder.hpp"

namespace moraine {
namespace {

using ManifestTest = ScratchFolder;

// Test vectors of NIST, "SHA-256 examples": no block, one block, two blocks, a million letters.
TEST(Sha256, AgreesWithNist) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

Manifest example() {
  Manifest manifest;
  manifest.build = build_info();
  manifest.threads = 4;
  manifest.precision = "mixed";
  manifest.case_file = "/somewhere/on/this/machine/case.toml";
  manifest.case_sha256 = sha256("");
  manifest.start_time = "2026-01-31T12:34:56Z";
  manifest.particles = 5000;
  return manifest;
}

TEST_F(ManifestTest, SaysThatTheRunGoesOn) {
  write_manifest(path("manifest.json"), example());
  auto const json = nlohmann::json::parse(bytes_of(path("manifest.json")));
  EXPECT_EQ(json["program"], "moraine");
  EXPECT_EQ(json["state"], "running");
  EXPECT_FALSE(json.contains("end"));
  EXPECT_EQ(json["threads"], 4);
  EXPECT_EQ(json["precision"], "mixed");
  EXPECT_EQ(json["case_file"], "case.toml");
  EXPECT_EQ(json["particles_at_start"], 5000);
  for (char const* key : {"version", "git_revision", "compiler", "compiler_flags", "simd"})
    EXPECT_FALSE(json[key].get<std::string>().empty()) << key;
}

TEST_F(ManifestTest, SaysHowTheRunEnded) {
  Manifest manifest = example();
  write_manifest(path("manifest.json"), manifest);
  manifest.end = RunEnd{"end time reached", 12.5, 0.25, 800, 4999};
  write_manifest(path("manifest.json"), manifest);
  auto const json = nlohmann::json::parse(bytes_of(path("manifest.json")));
  EXPECT_EQ(json["state"], "ended");
  EXPECT_EQ(json["end"]["reason"], "end time reached");
  EXPECT_EQ(json["end"]["wall_time_s"], 12.5);
  EXPECT_EQ(json["end"]["simulated_time_s"], 0.25);
  EXPECT_EQ(json["end"]["steps"], 800);
  EXPECT_EQ(json["end"]["particles"], 4999);
}

TEST_F(ManifestTest, HashesTheBytesOfAFile) {
  write(path("case.toml"), "abc");
  EXPECT_EQ(file_sha256(path("case.toml")), sha256("abc"));
  EXPECT_THROW(file_sha256(path("none.toml")), std::runtime_error);
}

TEST(UtcNow, IsIso8601) {
  std::string const now = utc_now();
  ASSERT_EQ(now.size(), 20U);
  EXPECT_GE(now.substr(0, 4), "2024");
  EXPECT_EQ(now[10], 'T');
  EXPECT_EQ(now[19], 'Z');
}

}  // namespace
}  // namespace moraine
