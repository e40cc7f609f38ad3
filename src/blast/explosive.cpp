#include "blast/explosive.hpp"

#include <algorithm>
#include <array>

namespace moraine::blast {
namespace {

constexpr std::string_view thesis =
    "factor on pressure and impulse; 2017 doctoral thesis on explosions in granular soil, ch. 3";

constexpr std::array<Explosive, 7> list{{
    {"tnt", 1.0, 1.0, "reference"},
    {"amatol", 1.04, 1.0, thesis},
    {"comp_b", 1.04, 1.0, thesis},
    {"tritonal", 1.17, 1.0, thesis},
    {"minol_2", 1.34, 1.0, thesis},
    {"hbx_2", 1.3, 1.0, thesis},
    {"c4", 1.0, 1.34, "TNT-equivalent mass, as commonly used for free air"},
}};

}  // namespace

std::span<Explosive const> explosives() { return list; }

Explosive const* find_explosive(std::string_view name) {
  auto const found = std::ranges::find(list, name, &Explosive::name);
  return found == list.end() ? nullptr : &*found;
}

}  // namespace moraine::blast
