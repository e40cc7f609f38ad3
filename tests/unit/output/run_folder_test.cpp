// Whose results a folder holds.
#include "output/run_folder.hpp"

#include <gtest/gtest.h>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class RunFolders : public ScratchFolder {
 protected:
  static BuildInfo build() {
    BuildInfo build = build_info();
    build.version = "1.2.0";
    build.git_revision = "abc";
    return build;
  }

  /// A manifest as a run of the case "digest" leaves it, changed by `change`.
  template <class Change>
  bool is_ours(Change change) const {
    Manifest manifest;
    manifest.build = build();
    manifest.case_sha256 = "digest";
    manifest.end = RunEnd{"end time reached"};
    change(manifest);
    write_manifest(path("manifest.json"), manifest);
    return has_results_of(path(""), "digest", build());
  }
};

TEST_F(RunFolders, HoldTheResultsOfOneCaseAndProgram) {
  EXPECT_FALSE(has_results_of(path(""), "digest", build())) << "there are none";
  EXPECT_TRUE(is_ours([](Manifest&) {}));
  EXPECT_FALSE(is_ours([](Manifest& m) { m.case_sha256 = "other"; }));
  EXPECT_FALSE(is_ours([](Manifest& m) { m.build.version = "1.1.0"; }));
  EXPECT_FALSE(is_ours([](Manifest& m) { m.build.git_revision = "abd"; }));
  EXPECT_FALSE(is_ours([](Manifest& m) { m.end->reason = "interrupted"; }));
  EXPECT_FALSE(is_ours([](Manifest& m) { m.end.reset(); })) << "killed";
  write(path("manifest.json"), "{\"case_sha");
  EXPECT_FALSE(has_results_of(path(""), "digest", build())) << "damaged";
}

}  // namespace
}  // namespace moraine
