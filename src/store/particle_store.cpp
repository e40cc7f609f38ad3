#include "store/particle_store.hpp"

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

std::size_t slot(Field field, int axis) {
  return static_cast<std::size_t>(field) * 3 + static_cast<std::size_t>(axis);
}

template <class T>
void reorder(std::vector<T>& values, std::vector<T>& scratch,
             std::span<std::uint32_t const> order) {
  std::size_t const count = std::min(values.size(), order.size());
  scratch.resize(values.size());
  for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) scratch[i] = values[order[i]];
  });
  std::copy(values.begin() + static_cast<std::ptrdiff_t>(count), values.end(),
            scratch.begin() + static_cast<std::ptrdiff_t>(count));
  values.swap(scratch);
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

ParticleStore::ParticleStore(int dimension) : dimension_(dimension), arrays_(field_count * 3) {}

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

std::size_t ParticleStore::append(Kind kind, MaterialId material) {
  for (FieldInfo const& field : field_table) {
    if (kind == Kind::wall && !field.on_walls) continue;
    int const components = field.rank == Rank::vector ? dimension_ : 1;
    for (int axis = 0; axis < components; ++axis) array(field.field, axis).push_back(0.0);
  }
  id_.push_back(next_id_++);
  material_.push_back(material);
  ++kind_size_[static_cast<std::size_t>(kind)];
  return size() - 1;
}

void ParticleStore::permute(std::span<std::uint32_t const> all, std::size_t count) {
  auto const order = all.first(count);
  // One scratch array per length, so that swapping never leaves a shorter one behind.
  for (FieldInfo const& field : field_table)
    for (int axis = 0; axis < 3; ++axis)
      if (auto& values = array(field.field, axis); !values.empty())
        reorder(values, field.on_walls ? scratch_all_ : scratch_fluid_, order);
  reorder(id_, scratch_id_, order);
  reorder(material_, scratch_material_, order);
}

void ParticleStore::remove(std::span<std::uint32_t const> indices) {
  for (std::uint32_t const i : indices) --kind_size_[i < kind_size_[0] ? 0 : 1];
  for (auto& values : arrays_) erase(values, indices);
  erase(id_, indices);
  erase(material_, indices);
}

void ParticleStore::shrink() {
  for (auto& values : arrays_) values.shrink_to_fit();
  id_.shrink_to_fit();
  material_.shrink_to_fit();
}

std::size_t ParticleStore::bytes() const {
  std::size_t sum = (scratch_all_.capacity() + scratch_fluid_.capacity()) * sizeof(double);
  for (auto const& values : arrays_) sum += values.capacity() * sizeof(double);
  sum += (id_.capacity() + scratch_id_.capacity()) * sizeof(std::uint64_t);
  return sum + (material_.capacity() + scratch_material_.capacity()) * sizeof(MaterialId);
}

}  // namespace moraine
