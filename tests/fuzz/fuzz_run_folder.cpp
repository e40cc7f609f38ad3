// Any bytes as the list of frames and as the manifest of a run.
#include <stdexcept>

#include "fuzzing.hpp"
#include "output/pvd_collection.hpp"
#include "output/run_folder.hpp"

using namespace moraine;

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  static fuzzing::Folder const folder;
  folder.write("manifest.json", fuzzing::text_of(data, size));
  has_written_its_end(folder.path());
  try {
    read_pvd(folder.write("particles.pvd", fuzzing::text_of(data, size)));
  } catch (std::runtime_error const& error) {
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
  }
  return 0;
}
