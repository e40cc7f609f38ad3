#include "store/particle_store.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

std::size_t slot(Field field, int component) {
  return static_cast<std::size_t>(field) * most_components + static_cast<std::size_t>(component);
}

/// "_x" of a vector, "_xy" of a matrix or a symmetric one, nothing of a scalar.
std::string suffix(Rank rank, int component, int dimension) {
  auto const pair = [](int a, int b) { return fmt::format("_{}{}", "xyz"[a], "xyz"[b]); };
  if (rank == Rank::scalar) return {};
  if (rank == Rank::vector) return fmt::format("_{}", "xyz"[component]);
  if (rank == Rank::matrix) return pair(component / dimension, component % dimension);
  if (component < dimension) return pair(component, component);
  int const beyond = component - dimension;  // xy, xz, yz
  return beyond == 0 ? pair(0, 1) : pair(beyond - 1, 2);
}

/// values[k] = values[order[k]], by way of a scratch array that arrays of all types share.
template <class T>
void reorder(std::span<T> values, std::vector<std::uint64_t>& scratch,
             std::span<std::uint32_t const> order) {
  static_assert(sizeof(T) <= sizeof(std::uint64_t) && std::is_trivially_copyable_v<T>);
  for_each_block(order.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      std::memcpy(&scratch[k], &values[order[k]], sizeof(T));
  });
  for_each_block(order.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) std::memcpy(&values[k], &scratch[k], sizeof(T));
  });
}

template <class T>
void erase(std::vector<T>& values, std::span<std::uint32_t const> indices) {
  std::size_t to = 0;
  std::size_t next = 0;
  for (std::size_t from = 0; from < values.size(); ++from) {
    if (next < indices.size() && indices[next] == from)
      ++next;
    else
      values[to++] = values[from];
  }
  values.resize(to);
}

}  // namespace

ParticleStore::ParticleStore(int dimension)
    : dimension_(dimension), arrays_(field_count * most_components) {}

Range ParticleStore::range(Kind kind) const {
  std::size_t const fluid = kind_size_[0];
  return kind == Kind::fluid ? Range{0, fluid} : Range{fluid, fluid + kind_size_[1]};
}

std::vector<double>& ParticleStore::array(Field field, int axis) {
  return arrays_[slot(field, axis)];
}

std::span<double> ParticleStore::component(Field field, int axis) { return array(field, axis); }

std::span<double const> ParticleStore::component(Field field, int axis) const {
  return arrays_[slot(field, axis)];
}

bool ParticleStore::has(Field field) const {
  return !info(field).optional || used_[static_cast<std::size_t>(field)];
}

void ParticleStore::use(Field field) {
  if (has(field)) return;
  used_[static_cast<std::size_t>(field)] = true;
  FieldInfo const& about = info(field);
  std::size_t const size = about.on_walls ? this->size() : kind_size_[0];
  for (int axis = 0; axis < components(about.rank, dimension_); ++axis)
    array(field, axis).assign(size, 0.0);
}

std::size_t ParticleStore::append(Kind kind, MaterialId material) {
  for (FieldInfo const& field : field_table) {
    if ((kind == Kind::wall && !field.on_walls) || !has(field.field)) continue;
    for (int axis = 0; axis < components(field.rank, dimension_); ++axis)
      array(field.field, axis).push_back(0.0);
  }
  id_.push_back(next_id_++);
  material_.push_back(material);
  ++kind_size_[static_cast<std::size_t>(kind)];
  return size() - 1;
}

void ParticleStore::permute(Kind kind, std::span<std::uint32_t const> order) {
  Range const of = range(kind);
  scratch_.resize(of.size());
  for (auto& values : arrays_)
    if (values.size() >= of.end && !values.empty())
      reorder(std::span(values).subspan(of.begin, of.size()), scratch_, order);
  reorder(std::span(id_).subspan(of.begin, of.size()), scratch_, order);
  reorder(std::span(material_).subspan(of.begin, of.size()), scratch_, order);
}

void ParticleStore::remove(std::span<std::uint32_t const> indices) {
  auto const walls = std::lower_bound(indices.begin(), indices.end(), kind_size_[0]);
  kind_size_[0] -= static_cast<std::size_t>(walls - indices.begin());
  kind_size_[1] -= static_cast<std::size_t>(indices.end() - walls);
  for_each_block(arrays_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) erase(arrays_[k], indices);
  });
  erase(id_, indices);
  erase(material_, indices);
}

void ParticleStore::shrink() {
  for (auto& values : arrays_) values.shrink_to_fit();
  id_.shrink_to_fit();
  material_.shrink_to_fit();
  std::vector<std::uint64_t>().swap(scratch_);
}

void ParticleStore::exchange(Archive& archive) {
  constexpr std::array kind_names{"fluid", "wall"};
  for (std::size_t k = 0; k < kind_count; ++k) {
    std::uint64_t size = kind_size_[k];
    archive.number(fmt::format("particles/{}_count", kind_names[k]), size);
    kind_size_[k] = size;
  }
  archive.number("particles/next_id", next_id_);
  archive.array("particles/id", "", id_);
  archive.array("particles/material", "", material_);
  exchange_used(archive);
  for (FieldInfo const& field : field_table)
    for (int axis = 0; axis < components(field.rank, dimension_); ++axis)
      exchange_field(archive, field, axis);
  if (id_.size() != kind_size_[0] + kind_size_[1] || material_.size() != id_.size())
    throw std::runtime_error("numbers of particles, ids and materials do not agree");
}

void ParticleStore::exchange_used(Archive& archive) {
  std::string names;
  for (FieldInfo const& field : field_table)
    if (field.optional && has(field.field)) names += fmt::format("{} ", field.name);
  archive.text("particles/optional_fields", names);
  for (FieldInfo const& field : field_table)
    used_[static_cast<std::size_t>(field.field)] =
        field.optional && names.find(fmt::format("{} ", field.name)) != std::string::npos;
}

void ParticleStore::exchange_field(Archive& archive, FieldInfo const& field, int axis) {
  auto& values = array(field.field, axis);
  if (!has(field.field)) {
    values.clear();
    return;
  }
  std::size_t const size = field.on_walls ? kind_size_[0] + kind_size_[1] : kind_size_[0];
  if (!field.saved) {
    if (archive.restoring()) values.assign(size, 0.0);
    return;
  }
  std::string const component = suffix(field.rank, axis, dimension_);
  archive.array(fmt::format("particles/{}{}", field.name, component), field.unit, values);
  if (values.size() != size)
    throw std::runtime_error(fmt::format("{} does not have one value per particle", field.name));
}

std::size_t ParticleStore::bytes() const {
  std::size_t sum = (id_.capacity() + scratch_.capacity()) * sizeof(std::uint64_t);
  for (auto const& values : arrays_) sum += values.capacity() * sizeof(double);
  return sum + material_.capacity() * sizeof(MaterialId);
}

}  // namespace moraine
