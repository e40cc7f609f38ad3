#include "output/checkpoint/start_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/checkpoint/seal.hpp"
#include "output/manifest.hpp"
#include "output/run_folder.hpp"
#include "setup/read_case.hpp"
#include "setup/region_lattice.hpp"
#include "setup/start_particles.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

[[noreturn]] void refuse(Case const& c, std::string rule, std::string hint = {}) {
  throw InputErrors({problem_of(c, "start.run", std::move(rule), std::move(hint))});
}

std::filesystem::path newest_checkpoint(Case const& c) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(c.start.run, ignored))
    refuse(c, "is not a folder", "name the folder of a run; its path counts from the case file");
  std::vector<std::string> skipped;
  auto const found = Checkpoints(c.start.run).newest(skipped);
  if (found) return *found;
  if (!holds_a_run(c.start.run)) refuse(c, "holds no run", "name the folder of a run");
  std::string why;
  for (std::string const& each : skipped) why += (why.empty() ? "" : ", ") + each;
  refuse(c, "has no whole checkpoint", why);
}

bool outside(Case const& c, ParticleStore const& store, std::size_t i) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    double const x = store.component(Field::position, static_cast<int>(axis))[i];
    if (!c.periodic[axis] && (x < c.domain.min[axis] || x > c.domain.max[axis])) return true;
  }
  return false;
}

/// Leaves the fluid inside the domain, in the order of ids.
void tidy(Case const& other, ParticleStore& store) {
  Range const fluid = store.range(Kind::fluid);
  std::vector<std::uint32_t> order(fluid.size());
  std::iota(order.begin(), order.end(), 0U);
  auto const ids = store.id();
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
  store.permute(Kind::fluid, order);
  std::vector<std::uint32_t> gone;
  for (std::size_t i = 0; i < store.size(); ++i)
    if (i >= fluid.end || outside(other, store, i)) gone.push_back(static_cast<std::uint32_t>(i));
  store.remove(gone);
  store.shrink();
}

StartInfo info_of(Case const& other) {
  StartInfo info;
  info.end = other.time.end;
  info.dimension = other.dimension;
  info.spacing = other.numerics.spacing;
  info.finest_spacing = finest_spacing(other);
  if (!other.start.run.empty())
    info.finest_spacing = std::min(info.finest_spacing, other.start.info.finest_spacing);
  for (MaterialSpec const& material : other.materials)
    info.materials.push_back({material.name, material_constants(other, material)});
  return info;
}

/// The other run's case, with what it knows of the run that it started from itself.
Case case_of(std::string const& text, std::filesystem::path const& folder) {
  Case other = parse_case(text, (folder / "case.used.toml").string());
  read_start_copy(other, folder);
  return other;
}

}  // namespace

void read_start(Case& c) {
  if (c.start.run.empty()) return;
  std::filesystem::path const folder = c.start.run;
  auto const checkpoint = newest_checkpoint(c);
  auto particles = std::make_shared<ParticleStore>(c.dimension);
  StartInfo& info = c.start.info;
  try {
    restore_hdf5(checkpoint, [&](Archive& archive) {
      exchange_layout(archive);
      std::string text;
      archive.text("case", text);
      Case const other = case_of(text, folder);
      info = info_of(other);
      archive.number("time", info.time);
      archive.number("step", info.step);
      *particles = ParticleStore(other.dimension);
      particles->exchange(archive);
      tidy(other, *particles);
    });
    info.checkpoint = checkpoint.filename().string();
    info.sha256 = file_sha256(checkpoint);
  } catch (std::runtime_error const& error) {
    refuse(c, fmt::format("cannot be started from: {}", error.what()));
  }
  auto const from = std::filesystem::absolute(c.file).parent_path();
  info.run = folder.lexically_relative(from.lexically_normal()).string();
  c.start.particles = std::move(particles);
  if (auto problems = start_problems(c); !problems.empty()) throw InputErrors(std::move(problems));
}

void write_start_copy(Case const& c, std::filesystem::path const& folder) {
  if (c.start.run.empty()) return;
  StartInfo info = c.start.info;
  ParticleStore particles = *c.start.particles;
  std::filesystem::path const path = folder / start_copy;
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  with_hdf5_image(
      [&](Archive& archive) {
        exchange_layout(archive);
        exchange_start(archive, info, particles);
      },
      [&](FileImage image) {
        seal(image);
        write_file(temporary, image);
      });
  publish(temporary, path);
}

void read_start_copy(Case& c, std::filesystem::path const& folder) {
  if (c.start.run.empty()) return;
  std::filesystem::path const path = folder / start_copy;
  if (std::string const why = broken_seal(path); !why.empty())
    throw std::runtime_error(
        fmt::format("{} {}: the state that the run started from is lost", path.string(), why));
  auto particles = std::make_shared<ParticleStore>(c.dimension);
  restore_hdf5(path, [&](Archive& archive) {
    exchange_layout(archive);
    exchange_start(archive, c.start.info, *particles);
  });
  c.start.particles = std::move(particles);
}

}  // namespace moraine
