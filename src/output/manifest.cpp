#include "output/manifest.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/simd_width.hpp"
#include "output/atomic_file.hpp"
#include "output/sha256.hpp"

#if !defined(MORAINE_VERSION)
#define MORAINE_VERSION "unknown"
#endif
#if !defined(MORAINE_GIT_REVISION)
#define MORAINE_GIT_REVISION "unknown"
#endif
#if !defined(MORAINE_COMPILER_FLAGS)
#define MORAINE_COMPILER_FLAGS "unknown"
#endif

namespace moraine {

BuildInfo build_info() {
#if defined(__clang__)
  std::string compiler = "Clang " __clang_version__;
#else
  std::string compiler = "GCC " __VERSION__;
#endif
  return {MORAINE_VERSION, MORAINE_GIT_REVISION, std::move(compiler), MORAINE_COMPILER_FLAGS,
          simd_flavour};
}

std::string utc_now() {
  auto const now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

std::string file_sha256(std::filesystem::path const& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("cannot read '{}'", path.string()));
  return sha256(std::string(std::istreambuf_iterator<char>(stream), {}));
}

void write_manifest(std::filesystem::path const& path, Manifest const& manifest) {
  nlohmann::ordered_json json{
      {"program", "moraine"},
      {"version", manifest.build.version},
      {"git_revision", manifest.build.git_revision},
      {"compiler", manifest.build.compiler},
      {"compiler_flags", manifest.build.compiler_flags},
      {"simd", manifest.build.simd},
      {"precision", manifest.precision},
      {"threads", manifest.threads},
      {"case_file", std::filesystem::path(manifest.case_file).filename().string()},
      {"case_sha256", manifest.case_sha256},
      {"start_time_utc", manifest.start_time},
      {"particles_at_start", manifest.particles},
      {"resumed_at_steps", manifest.resumed_at_steps},
      {"state", manifest.end ? "ended" : "running"},
  };
  if (manifest.start)
    json["start"] = {{"run", manifest.start->run},
                     {"checkpoint", manifest.start->checkpoint},
                     {"sha256", manifest.start->sha256},
                     {"time_s", manifest.start->time},
                     {"step", manifest.start->step}};
  for (StageEvent const& event : manifest.stages)
    json["stages"].push_back({{"name", event.stage},
                              {"time_s", event.time},
                              {"step", event.step},
                              {"cause", event.cause}});
  if (manifest.end) {
    json["end"] = {{"reason", manifest.end->reason},
                   {"wall_time_s", manifest.end->wall_time},
                   {"simulated_time_s", manifest.end->simulated_time},
                   {"steps", manifest.end->steps},
                   {"particles", manifest.end->particles}};
  }
  AtomicFile file(path);
  file.stream() << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  file.commit();
}

}  // namespace moraine
