#include "setup/mesh/stl_reader.hpp"

#include <fmt/core.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

namespace moraine {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of the file are copied");

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;
constexpr std::uintmax_t most_bytes = std::uintmax_t{2} << 30;

std::uint32_t announced_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() == header_bytes + triangle_bytes * std::size_t{announced_triangles(bytes)};
}

std::vector<Triangle> parse_binary(std::string_view bytes) {
  std::vector<Triangle> triangles((bytes.size() - header_bytes) / triangle_bytes);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), bytes.data() + header_bytes + triangle_bytes * i + 12,
                sizeof numbers);
    for (std::size_t k = 0; k < 9; ++k) {
      if (!std::isfinite(numbers[k]))
        throw StlError(
            fmt::format("has a coordinate that is no finite number in triangle {}", i + 1));
      triangles[i][k / 3][k % 3] = static_cast<double>(numbers[k]);
    }
  }
  return triangles;
}

class TextParser {
 public:
  explicit TextParser(std::string_view text) : text_(text) {}

  std::vector<Triangle> parse() {
    std::vector<Triangle> triangles;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (word != "solid") wrong(word, "\"solid\"");
      skip_line();  // the name, of any words
      for (word = next(); word != "endsolid"; word = next()) {
        if (word != "facet") wrong(word, "\"facet\" or \"endsolid\"");
        triangles.push_back(facet());
      }
      skip_line();
    }
    return triangles;
  }

 private:
  Triangle facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k) next();  // may be anything, zero and nan are usual
    expect("outer");
    expect("loop");
    Triangle triangle{};
    for (auto& corner : triangle) {
      expect("vertex");
      for (double& coordinate : corner) coordinate = number();
    }
    expect("endloop");
    expect("endfacet");
    return triangle;
  }

  double number() {
    std::string_view word = next();
    std::string_view const digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
      wrong(word, "a finite coordinate");
    return value;
  }

  void expect(std::string_view wanted) {
    std::string_view const word = next();
    if (word != wanted) wrong(word, fmt::format("\"{}\"", wanted));
  }

  [[noreturn]] void wrong(std::string_view word, std::string_view wanted) const {
    if (word.empty())
      throw StlError(fmt::format("ends in line {} where {} is expected", line_, wanted));
    throw StlError(
        fmt::format("has \"{}\" in line {} where {} is expected", printable(word), line_, wanted));
  }

  static std::string printable(std::string_view word) {
    std::string text;
    for (char const c : word.substr(0, 24))
      text +=
          static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7f ? c : '?';
    return text;
  }

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::string_view next() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
    std::size_t const begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

[[noreturn]] void refuse_kind(std::string_view bytes) {
  if (bytes.empty()) throw StlError("is empty");
  if (bytes.size() < header_bytes)
    throw StlError(fmt::format("is no STL file: it has {} bytes and does not begin with \"solid\"",
                               bytes.size()));
  std::uint32_t const announced = announced_triangles(bytes);
  std::size_t const held = (bytes.size() - header_bytes) / triangle_bytes;
  throw StlError(fmt::format(
      "is no STL file, or cut off: its header announces {} triangles, its length holds {}",
      announced, held));
}

}  // namespace

std::vector<Triangle> parse_stl(std::string_view bytes) {
  std::vector<Triangle> triangles;
  if (is_binary(bytes))
    triangles = parse_binary(bytes);
  else if (bytes.starts_with("solid"))
    triangles = TextParser(bytes).parse();
  else
    refuse_kind(bytes);
  if (triangles.empty()) throw StlError("holds no triangles");
  return triangles;
}

std::vector<Triangle> read_stl(std::filesystem::path const& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw StlError("does not exist");
  if (!std::filesystem::is_regular_file(path, error)) throw StlError("is not a file");
  std::uintmax_t const size = std::filesystem::file_size(path, error);
  if (error) throw StlError(fmt::format("cannot be read: {}", error.message()));
  if (size > most_bytes)
    throw StlError(fmt::format("has {} bytes; at most {} are read", size, most_bytes));
  std::string bytes(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw StlError("cannot be read");
  return parse_stl(bytes);
}

}  // namespace moraine
