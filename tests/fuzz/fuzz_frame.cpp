// Any bytes as a frame of particles: refused with a reason, or arrays of the announced length, and
// pictures of them.
#include <stdexcept>

#include "fuzzing.hpp"
#include "output/plot/plot.hpp"
#include "output/vtp_reader.hpp"

using namespace moraine;

namespace {

void check(FrameArray const& array, std::size_t size) {
  fuzzing::require(array.components > 0, "arrays have components");
  fuzzing::require(array.values.size() / array.components == size, "arrays are as long as said");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  static fuzzing::Folder const folder;
  auto const file = folder.write("frame.vtp", fuzzing::text_of(data, size));
  try {
    ParticleFrame const frame = read_vtp(file);
    check(frame.points, frame.size);
    for (FrameArray const& array : frame.arrays) check(array, frame.size);
    fuzzing::require(frame.dimension >= 1 && frame.dimension <= 3, "1 to 3 dimensions");
    for (char const* field : {"pressure", "velocity", "velocity_x"}) {
      if (frame.find(field) == nullptr && field != std::string("velocity_x")) continue;
      if (frame.dimension == 1)
        plot_profile(file, field, folder / "profile.svg");
      else
        plot_frame(file, field, folder / "frame.svg", {});
    }
  } catch (std::runtime_error const& error) {
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
  } catch (std::invalid_argument const& error) {  // a field that is not there
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
  }
  return 0;
}
