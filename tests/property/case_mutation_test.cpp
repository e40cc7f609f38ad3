// Random changes of the structure of the shipped cases: whatever the parser accepts, the schema
// accepts, what it refuses is refused with a message, and nothing else happens.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "setup/json_schema.hpp"
#include "setup/read_case.hpp"
#include "setup/starters.hpp"
#include "setup/toml.hpp"
#include "support/places.hpp"
#include "unit/output/scratch_folder.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// A key in some table of a case.
struct Spot {
  toml::table* table;
  std::string key;
  toml::node& node() const { return *table->get(key); }
};

void collect(toml::table& table, std::vector<Spot>& spots) {
  for (auto& [key, node] : table) {
    spots.push_back({&table, std::string(key.str())});
    if (auto* inner = node.as_table()) collect(*inner, spots);
    if (auto* list = node.as_array())
      for (auto& item : *list)
        if (auto* inner = item.as_table()) collect(*inner, spots);
  }
}

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutate(std::string_view text) {
    toml::table root = toml::parse(text);
    for (std::size_t count = 1 + pick(2); count > 0; --count) change(root);
    std::ostringstream stream;
    stream << root << '\n';
    return stream.str();
  }

 private:
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  template <class List>
  auto const& any_of(List const& list) {
    return list[pick(std::size(list))];
  }

  void change(toml::table& root) {
    std::vector<Spot> spots;
    collect(root, spots);
    if (spots.empty()) return;
    Spot const spot = any_of(spots);
    switch (pick(11)) {
      case 0:
        spot.table->erase(spot.key);
        return;
      case 1:
        return rename(spot);
      case 2:  // a copy under another key that occurs in the case
        return put(spot.table, any_of(spots).key, spot.node());
      case 3:
        return put(spot.table, spot.key, any_of(spots).node());
      case 4:
        return retype(spot);
      case 5:
        return number(spot);
      case 6:
        return unit(spot);
      case 7:
        return name(spot);
      case 8:  // wrapped in a list
        return put(spot.table, spot.key, toml::array{copy_of(spot.node())});
      case 9:
        return wrap_in_table(spot);
      default:
        return repeat_item(spot);
    }
  }

  static toml::array copy_of(toml::node const& node) {
    toml::array list;
    node.visit([&](auto const& value) { list.push_back(value); });
    return list;
  }

  // By way of a list, because the source may be a part of what is replaced.
  static void put(toml::table* table, std::string const& key, toml::node const& node) {
    toml::array const copy = copy_of(node);
    copy[0].visit([&](auto const& value) { table->insert_or_assign(key, value); });
  }

  void rename(Spot const& spot) {
    std::string other = spot.key;
    other[pick(other.size())] = static_cast<char>('a' + pick(26));
    put(spot.table, other, spot.node());
    if (other != spot.key) spot.table->erase(spot.key);
  }

  void retype(Spot const& spot) {
    switch (pick(7)) {
      case 0:
        spot.table->insert_or_assign(spot.key, 3);
        return;
      case 1:
        spot.table->insert_or_assign(spot.key, 0.5);
        return;
      case 2:
        spot.table->insert_or_assign(spot.key, "text");
        return;
      case 3:
        spot.table->insert_or_assign(spot.key, true);
        return;
      case 4:
        spot.table->insert_or_assign(spot.key, toml::array{});
        return;
      case 5:
        spot.table->insert_or_assign(spot.key, toml::table{});
        return;
      default:
        spot.table->insert_or_assign(spot.key, toml::date{1979, 5, 27});
    }
  }

  void number(Spot const& spot) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    static std::vector<double> const values{0.0, -1.0, 1e-300,       1e300,    0.9,
                                            1.7, 4.0,  std::nan(""), infinity, -infinity};
    replace(spot, any_of(values));
  }

  void unit(Spot const& spot) {
    static std::vector<std::string> const values{
        "3 kg",    "1 m",   "5 s",   "2 g0",  "45 deg",    "1",      "",        "abc",
        "1 m/s^2", "4 Pa",  "3km/s", "+2 m",  " 7 g/cm^3", "1 kJ/g", "1e999",   "-1e-3 s",
        ".5 cm",   "5. mm", "0 m",   "10 us", "50 %%",     "4 1/s",  "3 m^3/m2"};
    replace(spot, any_of(values));
  }

  void name(Spot const& spot) {
    static std::vector<std::string> const values{
        "tait",  "jwl",   "ideal_gas", "water_polynomial", "tnt",  "water_shock",  "air", "double",
        "mixed", "front", "point",     "volume",           "none", "cubic_spline", "x",   "y+"};
    replace(spot, any_of(values));
  }

  // The value itself, or an item of a list.
  template <class T>
  void replace(Spot const& spot, T const& value) {
    auto* list = spot.node().as_array();
    if (list == nullptr || list->empty() || pick(4) == 0) {
      spot.table->insert_or_assign(spot.key, value);
      return;
    }
    auto const place = list->cbegin() + static_cast<std::ptrdiff_t>(pick(list->size()));
    list->replace(place, value);
  }

  void wrap_in_table(Spot const& spot) {
    toml::table outer;
    put(&outer, spot.key, spot.node());
    spot.table->insert_or_assign(spot.key, outer);
  }

  void repeat_item(Spot const& spot) {
    auto* list = spot.node().as_array();
    if (list == nullptr || list->empty()) return;
    toml::array const item = copy_of((*list)[pick(list->size())]);
    item[0].visit([&](auto const& value) { list->push_back(value); });
  }

  std::mt19937_64 random_;
};

/// Mistakes that the schema sees too: keys that are unknown, missing or belong to another choice.
bool is_structural(InputProblem const& problem) {
  return problem.rule.starts_with("is an unknown key") ||
         problem.rule.starts_with("is missing: ") || problem.rule.starts_with("does not belong to");
}

class CaseMutation : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    std::filesystem::create_directory(path("good"));
    std::filesystem::create_directory(path("bad"));
    write(path("schema.json"), json_schema());
  }

  void sort_out(std::string const& text, std::string const& name) {
    try {
      parse_case(text, name);
      write(path("good/" + name), text);
      ++accepted_;
    } catch (InputErrors const& errors) {
      ASSERT_FALSE(errors.problems().empty());
      bool structural = false;
      for (auto const& problem : errors.problems()) {
        EXPECT_FALSE(problem.rule.empty()) << text;
        EXPECT_TRUE(format(problem).starts_with(name + ":")) << format(problem);
        // The domain is found by the walls, and upwards by the direction of gravity: not by keys.
        bool const by_values =
            problem.key == "space.domain" ||
            problem.rule.find("gravity points along no axis") != std::string::npos;
        structural = structural || (is_structural(problem) && !by_values);
      }
      if (structural) write(path("bad/" + name), text);
      refused_ += structural ? 1 : 0;
    }
  }

  /// The schema must accept the cases in good/ and refuse those in bad/.
  void compare() const {
    std::string const command = "/usr/bin/python3 " + source_folder() + "/tools/check_schema.py " +
                                path("schema.json").string() + ' ' + path("good").string() + ' ' +
                                path("bad").string() + " > " + path("log").string() + " 2>&1";
    int const status = std::system(command.c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
      GTEST_SKIP() << "install python3-jsonschema to compare schema and parser: "
                      "tools/install_packages.sh schema";
    EXPECT_EQ(status, 0) << bytes_of(path("log"));
  }

  int accepted_ = 0;
  int refused_ = 0;
};

TEST_F(CaseMutation, SchemaAgreesWithTheParser) {
  std::vector<std::string_view> texts;
  for (auto const& shipped : shipped_cases()) texts.push_back(shipped.text);
  for (auto const& starter : starter_texts()) texts.push_back(starter.text);
  constexpr int mutations = 200;
  Mutator mutator(20170501);
  for (std::size_t c = 0; c < texts.size(); ++c) {
    sort_out(std::string(texts[c]), "case_" + std::to_string(c) + ".toml");
    for (int k = 0; k < mutations; ++k)
      sort_out(mutator.mutate(texts[c]),
               "case_" + std::to_string(c) + "_" + std::to_string(k) + ".toml");
  }
  // Otherwise the comparison would say little.
  EXPECT_GT(accepted_, 100);
  EXPECT_GT(refused_, 300);
  compare();
}

TEST_F(CaseMutation, SchemaClosesShapesAndVectors) {
  auto const with = [](std::string const& shape, std::string const& more) {
    return "space.dimension = 2\nresolution.spacing = 0.1\ntime.end = 1\n"
           "material.water.use = \"water_shock\"\n[[region]]\nname = \"a\"\nmaterial = "
           "\"water\"\n" +
           shape + "\n" + more;
  };
  std::string const disc = "disc = { center = [0, 0], radius = 1 }";
  auto const nested = [&](std::string const& inner) {
    return "plus = [{ " + disc + ", minus = [{ " + inner + " }] }]";
  };
  for (std::string const& text : {with(disc, ""), with(disc, nested(disc))}) {
    parse_case(text, "case.toml");
    write(path("good/" + std::to_string(++accepted_) + ".toml"), text);
  }
  for (std::string const& text :
       {with(disc, nested("disc = { center = [0, 0], radius = 1, colour = 2 }")),
        with(disc, nested("ball = { center = [0, 0], radius = 1 }")), with(disc, nested("")),
        with(disc, nested(disc + ", box = { min = [0, 0], max = [1, 1] }")),
        with(disc, nested("disc = { center = [0, 0, 0], radius = 1 }")),
        with("disc = { center = [0], radius = 1 }", ""), with(disc, "velocity = [1, 2, 3]")}) {
    EXPECT_THROW(parse_case(text, "case.toml"), InputErrors) << text;
    write(path("bad/" + std::to_string(++refused_) + ".toml"), text);
  }
  compare();
}

}  // namespace
}  // namespace moraine
