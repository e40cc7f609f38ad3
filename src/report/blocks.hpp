// Numbers of a report: packed into blocks of compressed bytes (report/FORMAT.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moraine::report {

using Json = nlohmann::ordered_json;

/// zlib-compressed (RFC 1950) bytes as base64 (RFC 4648, section 4).
std::string packed(std::span<std::byte const> bytes);

/// One block: numbers are appended, and described as the type Numbers of the format.
class Block {
 public:
  explicit Block(std::string name) : name_(std::move(name)) {}

  std::string const& name() const { return name_; }

  /// Numbers as 64 or 32 bit floating point, little endian; what is not finite becomes
  /// not-a-number.
  Json add_f64(std::span<double const> values);
  Json add_f32(std::span<double const> values);
  Json add_u32(std::span<std::uint32_t const> values);
  Json add_u16(std::span<std::uint16_t const> values);
  Json add_u8(std::span<std::uint8_t const> values);

  std::string packed() const { return report::packed(bytes_); }

 private:
  template <class T>
  Json add(std::span<T const> values, std::string_view type);

  std::string name_;
  std::vector<std::byte> bytes_;
};

/// The blocks of a report, by name, ready to be written.
class Blocks {
 public:
  void add(Block const& block);
  void add(Blocks&& more);
  std::size_t size() const { return size_; }  // bytes of elements()

  /// As `<script>` elements.
  std::string elements() const;
  /// As an object of the JSON of a live page.
  Json object() const;
  /// Removes the blocks whose names begin so.
  void drop(std::string_view prefix);

 private:
  struct Packed {
    std::string name, text;
  };
  static std::string element_of(Packed const& block);
  std::vector<Packed> packed_;
  std::size_t size_ = 0;
};

}  // namespace moraine::report
