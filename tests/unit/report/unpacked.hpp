// Reads back what a report holds, by other means than it is written.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// Bytes of base64 text (RFC 4648), character by character.
inline std::string base64_decoded(std::string_view text) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (char const c : text) {
    if (c == '=') break;
    auto const digit = alphabet.find(c);
    if (digit == std::string_view::npos) {
      ADD_FAILURE() << "no base64: " << c;
      return {};
    }
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xffU);
  }
  return bytes;
}

inline std::string unpacked(std::string_view block, std::size_t most = 64'000'000) {
  std::string const packed = base64_decoded(block);
  std::string bytes(most, '\0');
  uLongf size = most;
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<Bytef const*>(packed.data()), packed.size()),
            Z_OK);
  bytes.resize(size);
  return bytes;
}

/// The numbers that a Numbers object of the format describes.
template <class T>
std::vector<T> numbers_in(std::string const& bytes, nlohmann::ordered_json const& numbers) {
  std::vector<T> values(numbers.at("count").get<std::size_t>());
  std::size_t const offset = numbers.at("offset");
  EXPECT_EQ(offset % sizeof(T), 0u);
  EXPECT_LE(offset + values.size() * sizeof(T), bytes.size());
  std::memcpy(values.data(), bytes.data() + offset, values.size() * sizeof(T));
  return values;
}

/// A page taken apart: its JSON and its blocks.
class PageReader {
 public:
  explicit PageReader(std::string page) : page_(std::move(page)) {
    report_ = nlohmann::ordered_json::parse(element("report"));
  }
  nlohmann::ordered_json const& report() const { return report_; }
  nlohmann::ordered_json const& run(std::size_t i = 0) const { return report_.at("runs").at(i); }

  template <class T>
  std::vector<T> numbers(nlohmann::ordered_json const& described) const {
    return numbers_in<T>(unpacked(element("block:" + described.at("block").get<std::string>())),
                         described);
  }
  /// The column with this label.
  std::vector<float> gauge(std::string const& label, std::size_t run_number = 0) const {
    for (auto const& table : run(run_number).at("tables"))
      for (auto const& column : table.at("columns"))
        if (column.at("label") == label && column.at("data").at("type") == "f32")
          return numbers<float>(column.at("data"));
    ADD_FAILURE() << "no column " << label;
    return {};
  }

 private:
  std::string element(std::string const& id) const {
    std::string const mark = "id=\"" + id + "\">";
    auto const begin = page_.find(mark);
    EXPECT_NE(begin, std::string::npos) << id;
    if (begin == std::string::npos) return "null";
    auto const from = begin + mark.size();
    return page_.substr(from, page_.find("</script>", from) - from);
  }

  std::string page_;
  nlohmann::ordered_json report_;
};

}  // namespace moraine
