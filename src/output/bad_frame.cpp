#include "output/bad_frame.hpp"

#include <algorithm>
#include <system_error>

#include "output/atomic_file.hpp"
#include "output/vtp_writer.hpp"

namespace moraine {
namespace {

std::filesystem::path frame_of(std::filesystem::path const& folder) {
  return folder / "bad" / "frame.vtp";
}

std::filesystem::path walls_of(std::filesystem::path const& folder) {
  return folder / "bad" / "walls.vtp";
}

}  // namespace

std::filesystem::path write_bad_frame(std::filesystem::path const& folder,
                                      Simulation const& simulation,
                                      std::vector<Flag> const& flags) {
  ParticleStore const& store = simulation.particles();
  std::uint64_t largest = 0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    largest = std::max(largest, store.id()[i]);
  std::vector<double> by_id(largest + 1, 0.0);
  for (Flag const& flag : flags)
    if (flag.particle <= largest) by_id[flag.particle] = flag.guard;
  write_vtp(frame_of(folder), store, Kind::fluid, simulation.time(), {{"guard", "", by_id}});
  if (store.range(Kind::wall).size() > 0)
    write_vtp(walls_of(folder), store, Kind::wall, simulation.time());
  return frame_of(folder);
}

void drop_bad_frame(std::filesystem::path const& folder) {
  remove_file(frame_of(folder));
  remove_file(walls_of(folder));
  std::error_code not_empty;  // files of others stay
  std::filesystem::remove(folder / "bad", not_empty);
}

}  // namespace moraine
