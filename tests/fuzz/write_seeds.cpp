// write_seeds FOLDER: for each fuzz target inputs to start from, FOLDER/TARGET/*, and a dictionary,
// FOLDER/TARGET.dict. All is made from the tables of the program and the cases that it ships with.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "base/units.hpp"
#include "samples.hpp"
#include "setup/parameter_table.hpp"

using namespace moraine;
namespace fs = std::filesystem;

namespace {

void write(fs::path const& file, std::string_view bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

/// A tetrahedron as binary STL.
std::string stl_binary() {
  std::string bytes(80, ' ');
  auto const add = [&bytes](auto value) {
    bytes.append(reinterpret_cast<char const*>(&value), sizeof value);
  };
  float const corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int const faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  add(std::uint32_t{4});
  for (auto const& face : faces) {
    for (int k = 0; k < 3; ++k) add(0.0F);
    for (int const corner : face)
      for (float const coordinate : corners[corner]) add(coordinate);
    add(std::uint16_t{0});
  }
  return bytes;
}

class Dictionary {
 public:
  void add(std::string_view word) {
    if (!word.empty()) words_.insert(std::string(word));
  }
  void save(fs::path const& file) const {
    std::string text;
    for (std::string const& word : words_) {
      text += '"';
      for (char const c : word) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
      }
      text += "\"\n";
    }
    write(file, text);
  }

 private:
  std::set<std::string> words_;
};

void add_units(Dictionary& dictionary) {
  for (std::size_t k = 0; k < quantity_count; ++k) {
    QuantityInfo const& about = info(static_cast<Quantity>(k));
    dictionary.add(about.unit);
    for (auto const unit : about.usual) dictionary.add(unit);
  }
  for (char const* word : {"degC", "1e308", "-1e-308", "nan", "inf", "lg(re 1 mW)", "@", "from"})
    dictionary.add(word);
}

Dictionary case_words() {
  Dictionary words;
  add_units(words);
  for (SectionInfo const& section : section_table) {
    words.add(section.key);
    words.add("[[" + std::string(section.key) + "]]");
  }
  for (Parameter const* parameter : all_parameters()) {
    words.add(parameter->key);
    for (std::string_view rest = parameter->key; !rest.empty();) {
      auto const dot = rest.find('.');
      words.add(rest.substr(0, dot));
      rest = dot == std::string_view::npos ? std::string_view{} : rest.substr(dot + 1);
    }
    for (auto const name : parameter->names) words.add(name);
  }
  for (auto const name : side_names) words.add(name);
  return words;
}

void write_case_seeds(fs::path const& folder) {
  write(folder / "rich.toml", fuzzing::rich_case());
  std::size_t count = 0;
  for (char const* part : {"cases", "starters"})
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(MORAINE_SOURCE_DIR) / part))
      if (entry.path().extension() == ".toml")
        fs::copy_file(entry.path(), folder / (std::to_string(++count) + ".toml"),
                      fs::copy_options::overwrite_existing);
}

void write_record_seeds(fs::path const& folder) {
  std::string const numbers = " .1000E-02  -.2000E-02\n  .3E-02  0.4D-02\n";
  write(
      folder / "record/at2",
      '\0' + ("PEER\nSTATION\nACCELERATION IN UNITS OF G\nNPTS=   4, DT=   .0050 SEC\n" + numbers));
  write(folder / "record/columns", '\0' + std::string("t_s,a_g\n0,1\n0.02,-2\n0.04,3\n"));
  write(folder / "record/blanks",
        '\0' + std::string("# made\ntime [ms] acceleration [m/s^2]\n0 1\n5 -2\n10 3\n"));
  write(folder / "record/plain", '\3' + numbers);
  Dictionary words;
  for (char const* word : {"NPTS=", "DT=", "UNITS OF G", "VELOCITY", "t_s", "a_g", "[m/s^2]", "(g)",
                           "a_cm_s2", "1e308", "-1e-308", "nan", "#"})
    words.add(word);
  words.save(folder / "record.dict");
}

void write_seeds(fs::path const& folder) {
  write_case_seeds(folder / "case_file");
  case_words().save(folder / "case_file.dict");
  Dictionary units;
  add_units(units);
  units.save(folder / "units.dict");
  for (std::size_t k = 0; k < quantity_count; ++k) {
    std::string const text = "1.5 " + std::string(info(static_cast<Quantity>(k)).usual[0]);
    write(folder / "units" / std::to_string(k), static_cast<char>(k) + text);
  }
  write(folder / "stl/text", fuzzing::stl_text());
  write(folder / "stl/binary", stl_binary());
  Dictionary stl;
  for (char const* word : {"solid", "facet", "normal", "outer", "loop", "vertex", "endloop",
                           "endfacet", "endsolid", "1e308", "-0", "nan"})
    stl.add(word);
  stl.save(folder / "stl.dict");
  write_record_seeds(folder);
  for (char const kind : {'r', 'c', 'a', 'i', 'd', 's', 'b', 'x'})
    write(folder / "checkpoint" / std::string(1, kind),
          std::string(1, kind) + std::string("\x10\2\0\0\1\0\0\0", 8));
  write(folder / "table/gauges", fuzzing::table_text());
  write(folder / "table/sums", fuzzing::sums_text());
  for (int dimension = 1; dimension <= 3; ++dimension)
    write(folder / "frame" / std::to_string(dimension), fuzzing::frame_bytes(dimension));
  write(folder / "run_folder/collection", fuzzing::collection_text());
  write(folder / "run_folder/manifest", fuzzing::manifest_text());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "write_seeds FOLDER\n");
    return 2;
  }
  write_seeds(argv[1]);
  return 0;
}
