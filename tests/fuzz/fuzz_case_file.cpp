// Any text as a case file: it is refused with messages, or it is a case that is written and read
// back unchanged and that becomes a model or is refused as too large before anything is allocated.
#include "base/input_error.hpp"
#include "fuzzing.hpp"
#include "samples.hpp"
#include "setup/build_model.hpp"
#include "setup/case_size.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

using namespace moraine;

namespace {

constexpr double most_bytes = 64e6;        // a machine small enough for the limit to be met often
constexpr double most_particles = 4000.0;  // more take long and show nothing else

fuzzing::Folder const& folder() {
  static fuzzing::Folder const folder;
  static auto const body = folder.write("body.stl", fuzzing::stl_text());
  return folder;
}

void check_messages(InputErrors const& errors) {
  fuzzing::require(!errors.problems().empty(), "errors without a message");
  for (InputProblem const& problem : errors.problems())
    fuzzing::require(!problem.rule.empty(), "a message without a rule");
}

void check_round_trip(Case const& c) {
  std::string const used = used_case(c);
  Case const again = parse_case(used, (folder() / "case.used.toml").string());
  fuzzing::require(used_case(again) == used, "a used case reads back unchanged");
}

void check_model(Case const& c) {
  check_size(c, most_bytes);
  if (estimate_size(c).particles() > most_particles) return;
  build_model(c);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  try {
    Case const c = parse_case(fuzzing::text_of(data, size), (folder() / "case.toml").string());
    try {
      check_round_trip(c);
    } catch (InputErrors const& errors) {
      std::fprintf(stderr, "%s\n", errors.what());
      fuzzing::require(false, "a used case is accepted");
    }
    check_model(c);
  } catch (InputErrors const& errors) {
    check_messages(errors);
  }
  return 0;
}
