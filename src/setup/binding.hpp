// How an entry of the table of parameters reaches its place in the Case: a pair of plain functions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "setup/parameter.hpp"

namespace moraine {

/// A parameter and its place in a Target (Case, MaterialSpec, ...). `set` gets a checked value of
/// the parameter's type; `get` returns monostate where the Target has no such value.
template <class Target>
struct Entry {
  Parameter parameter;
  void (*set)(Target&, Value const&);
  Value (*get)(Target const&);
};

namespace binding {

using Sides = std::array<std::array<bool, 2>, 3>;
using Axes = std::array<bool, 3>;

using Points = std::vector<std::array<double, 3>>;

template <class Place>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class Place>
void store(Place& place, Value const& value) {
  if constexpr (std::is_enum_v<Place>) {
    place = static_cast<Place>(std::get<int>(value));
  } else if constexpr (is_optional<Place>) {
    place = std::get<typename Place::value_type>(value);
  } else if constexpr (std::is_same_v<Place, Points>) {
    auto const& numbers = std::get<std::vector<double>>(value);
    place.clear();
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
      place.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  } else if constexpr (std::is_same_v<Place, Axes>) {
    for (int const axis : std::get<std::vector<int>>(value))
      place[static_cast<std::size_t>(axis)] = true;
  } else if constexpr (std::is_same_v<Place, Sides>) {
    for (int const side : std::get<std::vector<int>>(value))
      place[static_cast<std::size_t>(side / 2)][static_cast<std::size_t>(side % 2)] = true;
  } else {
    place = std::get<Place>(value);
  }
}

template <class Place>
Value load(Place const& place) {
  if constexpr (std::is_enum_v<Place>) {
    return static_cast<int>(place);
  } else if constexpr (is_optional<Place>) {
    return place ? Value(*place) : Value();
  } else if constexpr (std::is_same_v<Place, Points>) {
    std::vector<double> numbers;
    for (auto const& point : place) numbers.insert(numbers.end(), point.begin(), point.end());
    return numbers;
  } else if constexpr (std::is_same_v<Place, std::string>) {
    return place.empty() ? Value() : Value(place);
  } else if constexpr (std::is_same_v<Place, Axes> || std::is_same_v<Place, Sides>) {
    std::vector<int> indices;
    int index = 0;
    for (auto const& item : place) {
      if constexpr (std::is_same_v<Place, Axes>) {
        if (item) indices.push_back(index);
        ++index;
      } else {
        for (bool const side : item) {
          if (side) indices.push_back(index);
          ++index;
        }
      }
    }
    return indices;
  } else {
    return place;
  }
}

/// Follows member pointers: path<&Case::numerics, &Numerics::spacing>(c) is c.numerics.spacing.
template <auto First, auto... Rest, class Target>
constexpr auto& path(Target& target) {
  if constexpr (sizeof...(Rest) == 0)
    return target.*First;
  else
    return path<Rest...>(target.*First);
}

template <class Variant, std::size_t... I>
void emplace(Variant& variant, std::size_t index, std::index_sequence<I...>) {
  ((I == index ? void(variant.template emplace<I>()) : void()), ...);
}

}  // namespace binding

/// An entry bound to a member, reached through members.
template <class Target, auto... Members>
Entry<Target> member(Parameter parameter) {
  return {std::move(parameter),
          [](Target& target, Value const& value) {
            binding::store(binding::path<Members...>(target), value);
          },
          [](Target const& target) { return binding::load(binding::path<Members...>(target)); }};
}

/// An entry that chooses the alternative of a variant: its names are in the variant's order.
template <class Target, auto Variant>
Entry<Target> alternative(Parameter parameter) {
  return {std::move(parameter),
          [](Target& target, Value const& value) {
            using V = std::remove_reference_t<decltype(target.*Variant)>;
            binding::emplace(target.*Variant, static_cast<std::size_t>(std::get<int>(value)),
                             std::make_index_sequence<std::variant_size_v<V>>{});
          },
          [](Target const& target) { return Value(static_cast<int>((target.*Variant).index())); }};
}

/// An entry bound to a member of one alternative of a variant; monostate where another is held.
template <class Target, auto Variant, class Alternative, auto Member>
Entry<Target> member_of(Parameter parameter) {
  return {std::move(parameter),
          [](Target& target, Value const& value) {
            binding::store(std::get<Alternative>(target.*Variant).*Member, value);
          },
          [](Target const& target) {
            auto const* held = std::get_if<Alternative>(&(target.*Variant));
            return held != nullptr ? binding::load(held->*Member) : Value();
          }};
}

}  // namespace moraine
