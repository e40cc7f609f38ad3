// Any text as a ground motion record: refused with messages, or read, and read back when written.
#include <cmath>

#include "base/input_error.hpp"
#include "fuzzing.hpp"
#include "records/ground_record.hpp"
#include "records/record_reader.hpp"
#include "records/record_writer.hpp"

using namespace moraine;

namespace {

GroundRecord must_read(std::string const& text) {
  try {
    return parse_record(text, "written", {});
  } catch (InputErrors const& errors) {
    std::fprintf(stderr, "%s\n", errors.what());
    fuzzing::require(false, "what was written reads back");
    throw;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  if (size == 0) return 0;
  RecordHints hints;
  if ((data[0] & 1U) != 0) hints.unit = "g";
  if ((data[0] & 2U) != 0) hints.time_step = 0.01;
  GroundRecord record;
  try {
    record = parse_record(fuzzing::text_of(data + 1, size - 1), "record", hints);
  } catch (InputErrors const& errors) {
    fuzzing::require(!errors.problems().empty(), "a refusal has messages");
    return 0;
  }
  check_record(record);
  // Steps that are nothing against the start cannot be written as times.
  if (!(record.time_step > 1e-9 * std::abs(record.start)) || record.time_step < 1e-300) return 0;
  fuzzing::require(must_read(record_as_csv(record)).acceleration == record.acceleration,
                   "CSV keeps all digits");
  fuzzing::require(must_read(record_as_at2(record)).size() == record.size(),
                   "AT2 keeps the length");
  return 0;
}
