#include "setup/region_table.hpp"

namespace moraine {
namespace {

constexpr auto layers = &RegionSpec::layers;
constexpr auto rotation = &InitialState::rotation;

// An entry whose value is shown only where there are layers.
template <auto Member>
Entry<RegionSpec> layer_entry(Parameter parameter) {
  parameter.section = Section::region;
  Entry<RegionSpec> entry = member<RegionSpec, layers, Member>(std::move(parameter));
  entry.get = [](RegionSpec const& region) {
    return region.layers.materials.empty() ? Value() : binding::load(region.layers.*Member);
  };
  return entry;
}

template <auto Member>
Entry<RegionSpec> rotation_entry(Parameter parameter) {
  parameter.section = Section::region;
  Entry<RegionSpec> entry =
      member<RegionSpec, &RegionSpec::initial, rotation, Member>(std::move(parameter));
  entry.get = [](RegionSpec const& region) {
    Rotation const& held = region.initial.rotation;
    return held.rate ? binding::load(held.*Member) : Value();
  };
  return entry;
}

}  // namespace

void add_layer_entries(std::vector<Entry<RegionSpec>>& table) {
  table.push_back(layer_entry<&Layers::materials>(
      {.key = "layers.materials",
       .type = ValueType::texts,
       .presence = Presence::with_table,
       .meaning = "materials of the layers, from the top downwards; takes the place of material"}));
  table.push_back(layer_entry<&Layers::thickness>(
      {.key = "layers.thickness",
       .type = ValueType::reals,
       .quantity = Quantity::length,
       .presence = Presence::with_table,
       .limits = Limits::positive(),
       .meaning = "thicknesses of the layers; without the last one that layer has no lower end"}));
  table.push_back(layer_entry<&Layers::top>(
      {.key = "layers.top",
       .quantity = Quantity::length,
       .preset_note = "the highest point of the shape",
       .meaning = "height of the top of the uppermost layer, against gravity"}));
}

void add_spacing_entries(std::vector<Entry<RegionSpec>>& table) {
  table.push_back(member<RegionSpec, &RegionSpec::spacing>(
      {.section = Section::region,
       .key = "spacing",
       .quantity = Quantity::length,
       .preset_note = "resolution.spacing, on the lattice of the case",
       .limits = Limits::positive(),
       .meaning = "distance of neighbouring particles on a lattice of this region's own; the "
                  "smoothing length is that of the case unless it varies"}));
  table.push_back(member<RegionSpec, &RegionSpec::equal_mass_with>(
      {.section = Section::region,
       .key = "equal_mass_with",
       .type = ValueType::text,
       .preset_note = "masses follow from the spacing",
       .meaning = "name of the region whose particles have the same mass as those of this one: "
                  "the spacing is that region's times (its density / the density here)^(1/d)"}));
}

void add_start_entries(std::vector<Entry<RegionSpec>>& table) {
  constexpr auto field = &InitialState::velocity_field;
  Entry<RegionSpec> velocities =
      member<RegionSpec, &RegionSpec::initial, field, &VelocityField::texts>(
          {.section = Section::region,
           .key = "velocity_field",
           .type = ValueType::texts,
           .preset_note = "none",
           .meaning = "velocities in m/s that are added to the velocity: formulas of the place x, "
                      "y, z in m, one for each axis, such as \"0.1 * sin(2 * pi * y)\""});
  velocities.get = [](RegionSpec const& region) {
    auto const& texts = region.initial.velocity_field.texts;
    return texts.empty() ? Value() : Value(texts);
  };
  table.push_back(std::move(velocities));
  table.push_back(rotation_entry<&Rotation::rate>(
      {.key = "rotation.rate",
       .quantity = Quantity::angular_velocity,
       .presence = Presence::with_table,
       .meaning = "angular velocity of a rigid rotation, added to the velocity; right-handed"}));
  table.push_back(rotation_entry<&Rotation::center>({.key = "rotation.center",
                                                     .type = ValueType::vector,
                                                     .quantity = Quantity::length,
                                                     .preset = Point{},
                                                     .meaning = "a point of the axis"}));
  Entry<RegionSpec> axis =
      rotation_entry<&Rotation::axis>({.key = "rotation.axis",
                                       .type = ValueType::vector,
                                       .preset_note = "z",
                                       .meaning = "3D: direction of the axis, of any length"});
  axis.get = [](RegionSpec const& region) {  // 2D has no such key
    Rotation const& held = region.initial.rotation;
    return held.rate && held.axis != Rotation{}.axis ? Value(held.axis) : Value();
  };
  table.push_back(std::move(axis));
  table.push_back(member<RegionSpec, &RegionSpec::initial, &InitialState::lithostatic_load>(
      {.section = Section::region,
       .key = "lithostatic_load",
       .quantity = Quantity::pressure,
       .preset_note = "no lithostatic pressure",
       .limits = Limits::not_negative(),
       .meaning = "pressure on the ground; the weight of all regions above is added to it, and the "
                  "density is solved for the sum"}));
}

}  // namespace moraine
