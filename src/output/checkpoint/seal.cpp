#include "output/checkpoint/seal.hpp"

#include <fmt/core.h>
#include <xxhash.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <vector>

namespace moraine {
namespace {

/// A checksum in the making.
class Checksum {
 public:
  Checksum() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
  void add(char const* bytes, std::size_t count) {
    XXH3_128bits_update(state_.get(), bytes, count);
    length_ += count;
  }
  /// The seal of a file whose bytes behind the seal were added.
  std::string seal() const {
    XXH128_hash_t const hash = XXH3_128bits_digest(state_.get());
    std::string text = fmt::format("moraine checkpoint, {} bytes, xxh3 {:016x}{:016x}",
                                   seal_size + length_, hash.high64, hash.low64);
    text.resize(seal_size - 1, ' ');
    return text + '\n';
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
  std::uint64_t length_ = 0;
};

std::string seal_of(std::ifstream& file) {
  Checksum checksum;
  std::vector<char> buffer(std::size_t{1} << 20);
  file.seekg(static_cast<std::streamoff>(seal_size));
  while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), file.gcount() > 0)
    checksum.add(buffer.data(), static_cast<std::size_t>(file.gcount()));
  return checksum.seal();
}

}  // namespace

void seal(FileImage file) {
  Checksum checksum;
  checksum.add(file.data() + seal_size, file.size() - seal_size);
  checksum.seal().copy(file.data(), seal_size);
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
