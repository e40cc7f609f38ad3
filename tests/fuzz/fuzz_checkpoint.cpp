// Changes of a sealed checkpoint, and any bytes as one: it is refused unless every byte is as it
// was sealed, and then holds what was saved.
//
// The input is a list of edits: a letter, then numbers of four bytes.
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "fuzzing.hpp"
#include "output/checkpoint/checkpoints.hpp"

using namespace moraine;

namespace {

struct State {
  std::vector<double> numbers{1.0, -2.5, 1e300};
  std::vector<std::uint32_t> ids{7, 8, 9};
  std::string text = "[space]\ndimension = 2\n";

  void exchange(Archive& archive) {
    archive.array("particles/density", "kg/m^3", numbers);
    archive.array("particles/id", "", ids);
    archive.text("case", text);
  }
  bool operator==(State const&) const = default;
};

struct Sample {
  fuzzing::Folder folder;
  std::filesystem::path file;
  std::string bytes;

  Sample() {
    State state;
    Checkpoints(folder.path()).save(1, [&](Archive& archive) { state.exchange(archive); });
    std::vector<std::string> skipped;
    file = *Checkpoints(folder.path()).newest(skipped);
    std::ifstream stream(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
};

class Edits {
 public:
  Edits(unsigned char const* data, std::size_t size) : data_(data), size_(size) {}

  void apply(std::string& bytes) {
    while (at_ < size_) {
      char const kind = static_cast<char>(data_[at_++]);
      std::size_t const place = bytes.empty() ? 0 : number() % bytes.size();
      if (kind == 'r') {
        bytes.assign(reinterpret_cast<char const*>(data_ + at_), size_ - at_);  // any bytes
        return;
      }
      if (bytes.empty()) return;
      if (kind == 'c') bytes.resize(place);
      if (kind == 'a' && bytes.size() < longest) bytes.append(place, static_cast<char>(number()));
      if (kind == 'i') bytes.insert(place, 1, static_cast<char>(number()));
      if (kind == 'd') bytes.erase(place, 1);
      if (kind == 's') std::swap(bytes[place], bytes[number() % bytes.size()]);
      if (kind == 'b') bytes[place] = static_cast<char>(number());
      if (kind == 'x') bytes[place] = static_cast<char>(bytes[place] ^ (1 << (number() % 8)));
    }
  }

 private:
  static constexpr std::size_t longest = 1 << 22;  // each appending may double the file

  std::size_t number() {
    std::uint32_t value = 0;
    std::size_t const count = std::min(sizeof value, size_ - at_);
    std::memcpy(&value, data_ + at_, count);
    at_ += count;
    return value;
  }

  unsigned char const* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  static Sample const sample;
  std::string bytes = sample.bytes;
  Edits(data, size).apply(bytes);
  std::ofstream(sample.file, std::ios::binary | std::ios::trunc) << bytes;
  std::vector<std::string> skipped;
  auto const found = Checkpoints(sample.folder.path()).newest(skipped);
  fuzzing::require(found.has_value() == (bytes == sample.bytes), "only what was sealed is whole");
  fuzzing::require(found.has_value() == skipped.empty(), "what is passed over has a reason");
  if (!found) return 0;
  State restored{{}, {}, {}};
  restore_hdf5(*found, [&](Archive& archive) { restored.exchange(archive); });
  fuzzing::require(restored == State(), "a whole checkpoint holds what was saved");
  return 0;
}
