#include "output/checkpoint/seal.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"

namespace moraine {
namespace {

/// The seal that belongs to the bytes of a file behind its first seal_size.
std::string seal_of(std::ifstream& file) {
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> const state(XXH3_createState(),
                                                                              XXH3_freeState);
  XXH3_128bits_reset(state.get());
  file.seekg(static_cast<std::streamoff>(seal_size));
  std::vector<char> buffer(std::size_t{1} << 20);
  std::uint64_t length = seal_size;
  for (;;) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    auto const got = static_cast<std::size_t>(file.gcount());
    if (got == 0) break;
    XXH3_128bits_update(state.get(), buffer.data(), got);
    length += got;
  }
  XXH128_hash_t const hash = XXH3_128bits_digest(state.get());
  std::string text = fmt::format("moraine checkpoint, {} bytes, xxh3 {:016x}{:016x}", length,
                                 hash.high64, hash.low64);
  text.resize(seal_size - 1, ' ');
  return text + '\n';
}

}  // namespace

void seal(std::filesystem::path const& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read back '" + path.string() + "'");
  std::string const text = seal_of(file);
  std::fstream out(path, std::ios::binary | std::ios::in | std::ios::out);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write '" + path.string() + "'");
  sync_to_disk(path);
}

std::string broken_seal(std::filesystem::path const& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return "cannot be read";
  std::string found(seal_size, '\0');
  file.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (static_cast<std::size_t>(file.gcount()) < seal_size) return "is cut off";
  if (!found.starts_with("moraine checkpoint, ")) return "is not a checkpoint";
  return seal_of(file) == found ? "" : "is damaged: its checksum does not fit its content";
}

}  // namespace moraine
