#include "report/blocks.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace moraine::report {
namespace {

static_assert(std::endian::native == std::endian::little);

std::string compressed(std::span<std::byte const> bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  auto const* from = reinterpret_cast<Bytef const*>(bytes.data());
  // Level 6: 9 takes three times as long for one per cent of quantised places.
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, from, static_cast<uLong>(bytes.size()),
                6) != Z_OK)
    throw std::runtime_error("a block of a report cannot be compressed");
  out.resize(size);
  return out;
}

std::string base64(std::string const& bytes) {
  using namespace boost::archive::iterators;
  using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Encoder(bytes.begin()), Encoder(bytes.end()));
  text.append((4 - text.size() % 4) % 4, '=');
  return text;
}

template <class T>
std::vector<T> clean(std::span<double const> values) {
  std::vector<T> out;
  out.reserve(values.size());
  for (double const value : values) {
    auto const number = static_cast<T>(value);
    out.push_back(std::isfinite(number) ? number : std::numeric_limits<T>::quiet_NaN());
  }
  return out;
}

}  // namespace

std::string packed(std::span<std::byte const> bytes) { return base64(compressed(bytes)); }

template <class T>
Json Block::add(std::span<T const> values, std::string_view type) {
  // Typed arrays of the browser begin at multiples of their element.
  bytes_.resize((bytes_.size() + sizeof(T) - 1) / sizeof(T) * sizeof(T));
  Json const numbers{
      {"block", name_}, {"offset", bytes_.size()}, {"count", values.size()}, {"type", type}};
  auto const bytes = std::as_bytes(values);
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return numbers;
}

Json Block::add_f64(std::span<double const> values) {
  return add<double>(clean<double>(values), "f64");
}
Json Block::add_f32(std::span<double const> values) {
  return add<float>(clean<float>(values), "f32");
}
Json Block::add_u32(std::span<std::uint32_t const> values) { return add(values, "u32"); }
Json Block::add_u16(std::span<std::uint16_t const> values) { return add(values, "u16"); }
Json Block::add_u8(std::span<std::uint8_t const> values) { return add(values, "u8"); }

void Blocks::add(Block const& block) {
  packed_.push_back({block.name(), block.packed()});
  size_ += element_of(packed_.back()).size();
}

void Blocks::add(Blocks&& more) {
  size_ += std::exchange(more.size_, 0);
  std::move(more.packed_.begin(), more.packed_.end(), std::back_inserter(packed_));
  more.packed_.clear();
}

std::string Blocks::element_of(Packed const& block) {
  return fmt::format("<script type=\"text/plain\" id=\"block:{}\">{}</script>\n", block.name,
                     block.text);
}

std::string Blocks::elements() const {
  std::string text;
  text.reserve(size_);
  for (Packed const& block : packed_) text += element_of(block);
  return text;
}

Json Blocks::object() const {
  Json object = Json::object();
  for (Packed const& block : packed_) object[block.name] = block.text;
  return object;
}

void Blocks::drop(std::string_view prefix) {
  std::erase_if(packed_, [&](Packed const& block) {
    if (!block.name.starts_with(prefix)) return false;
    size_ -= element_of(block).size();
    return true;
  });
}

}  // namespace moraine::report
