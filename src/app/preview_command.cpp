// moraine preview: what a case looks like, without running it.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/plot/plot_preview.hpp"
#include "output/vtp_writer.hpp"
#include "setup/build_model.hpp"
#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/read_case.hpp"
#include "setup/region_lattice.hpp"
#include "setup/start_particles.hpp"
#include "store/place.hpp"

namespace moraine {
namespace {

/// Beside the results of `moraine run`.
std::filesystem::path default_folder(std::string const& case_file) {
  auto const path = std::filesystem::weakly_canonical(case_file);
  std::string const name =
      path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
  return std::filesystem::path("out") / (name + "-preview");
}

/// A preview must not mix with the results of a run, whose files have the same names.
void check_folder(std::filesystem::path const& folder) {
  std::error_code ignored;
  std::string rule;
  if (std::filesystem::exists(folder / "manifest.json", ignored))
    rule = "holds the results of a run";
  else if (std::filesystem::exists(folder, ignored) &&
           !std::filesystem::is_directory(folder, ignored))
    rule = "cannot be a folder: it is a file";
  if (!rule.empty())
    throw InputErrors({{"moraine preview", 0, 0, "--output", fmt::format("\"{}\"", folder.string()),
                        std::move(rule), "choose another folder with --output"}});
}

/// Pressure and sound speed, which a model does not have before its first step.
void add_pressure(Model& model) {
  ParticleStore& store = model.particles;
  Range const fluid = store.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i) {
    double const density = store.scalar(Field::density)[i];
    double const energy = store.scalar(Field::specific_energy)[i];
    Material const& material = model.materials[store.material()[i]];
    StateResponse const state = std::visit(
        [&](auto const& law) {
          if constexpr (is_products<std::decay_t<decltype(law)>>)
            if (material.burn)
              return material.burn->law.respond(law, density, energy,
                                                store.scalar(Field::burn_fraction)[i]);
          if constexpr (is_compactable<std::decay_t<decltype(law)>>) {
            double& distension = store.scalar(Field::distension)[i];
            auto const loaded = law.respond(density, energy, distension);
            distension = loaded.distension;
            return StateResponse{loaded.pressure, signed_root(loaded.unloading_speed_squared)};
          }
          return law.respond(density, energy);
        },
        material.eos);
    store.scalar(Field::pressure)[i] = state.pressure;
    store.scalar(Field::sound_speed)[i] = state.sound_speed;
  }
}

/// Particles on the faces of walls without dummies, so that they are seen.
void add_faces(Model& model) {
  for (WallFace const& face : model.walls.faces)
    for (Vec3 const& place : face_particles(face, model.dimension)) {
      std::size_t const i = model.particles.append(Kind::wall, no_material);
      for (int axis = 0; axis < model.dimension; ++axis)
        model.particles.component(Field::position, axis)[i] = place[static_cast<std::size_t>(axis)];
    }
}

ParticleStore probes_of(Case const& c) {
  ParticleStore store(c.dimension);
  for (auto const& gauge : c.gauges) {
    if (gauge.kind != GaugeKind::point) continue;
    std::size_t const i = store.append(Kind::fluid, no_material);
    for (int axis = 0; axis < c.dimension; ++axis)
      store.component(Field::position, axis)[i] = gauge.position[static_cast<std::size_t>(axis)];
  }
  return store;
}

/// Slices go through the middle of the last region that has bounds: what was put in last is what
/// one wants to see.
Vec3 place_of_slices(Case const& c) {
  for (std::size_t i = c.regions.size(); i-- > 0;)
    if (auto const box = bounding_box_of_tree(c.regions[i], c.dimension))
      return scale(0.5, add(box->min, box->max));
  return scale(0.5, add(c.domain.min, c.domain.max));
}

/// The place of the layer of particles that is nearest along each axis.
Vec3 on_a_layer(Vec3 place, ParticleStore const& store) {
  Vec3 nearest = place;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 least{infinity, infinity, infinity};
  Range const fluid = store.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double const x = place_of(store, i)[axis];
      if (std::abs(x - place[axis]) >= least[axis]) continue;
      least[axis] = std::abs(x - place[axis]);
      nearest[axis] = x;
    }
  return nearest;
}

/// The particles that come from another run.
PreviewPart start_part(Case const& c) {
  PreviewPart part{"from " + std::filesystem::path(c.start.run).filename().string(), {}, 0.0};
  for (std::size_t const i : kept_start_particles(c))
    part.positions.push_back(place_of(*c.start.particles, i));
  return part;
}

/// A part for each region, or for each of its layers.
std::vector<PreviewPart> parts_of(Case const& c, std::vector<Seed> const& seeds) {
  std::map<std::pair<std::size_t, MaterialId>, PreviewPart> parts;
  auto const lattices = lattices_of_regions(c);
  for (Seed const& seed : seeds) {
    PreviewPart& part = parts[{seed.region, seed.material}];
    part.name = c.regions[seed.region].name;
    part.spacing = lattices[seed.region].spacing;
    if (!c.regions[seed.region].layers.materials.empty())
      part.name += ", " + c.materials[seed.material].name;
    part.positions.push_back(seed.position);
  }
  std::vector<PreviewPart> list;
  if (!c.start.run.empty()) list.push_back(start_part(c));
  for (auto& [key, part] : parts) list.push_back(std::move(part));
  return list;
}

Preview preview_of(Case const& c, Model const& model, std::vector<Seed> const& seeds) {
  ParticleStore const& store = model.particles;
  Preview preview;
  preview.dimension = c.dimension;
  preview.spacing = c.numerics.spacing;
  preview.regions = parts_of(c, seeds);
  Range const walls = store.range(Kind::wall);
  for (std::size_t i = walls.begin; i < walls.end; ++i) preview.walls.push_back(place_of(store, i));
  for (auto const& gauge : c.gauges)
    if (gauge.kind == GaugeKind::point) preview.probes.push_back({gauge.name, {gauge.position}});
  if (c.dimension == 3) preview.at = on_a_layer(place_of_slices(c), store);
  return preview;
}

void say_bodies(ShapeTree const& tree, std::string const& region) {
  if (auto const* stl = std::get_if<StlBody>(&tree.shape)) {
    MeshReport const& report = stl->body->report;
    fmt::print("body of {}: {}, {} triangles, volume {:.6g} m^3, {}\n", region,
               std::filesystem::path(stl->file).filename().string(), report.triangles,
               std::abs(report.volume),
               report.watertight() ? "watertight" : "not closed: " + defects_text(report, 10));
  }
  for (auto const* list : {&tree.plus, &tree.minus})
    for (ShapeTree const& part : *list) say_bodies(part, region);
}

void say_start_counts(Case const& c, std::string const& unit) {
  auto const kept = kept_start_particles(c);
  double mass = 0.0;
  for (std::size_t const i : kept) mass += c.start.particles->scalar(Field::mass)[i];
  std::size_t const all = c.start.particles->range(Kind::fluid).size();
  fmt::print("from {}: {} particles, {:.6g} {}{}\n", c.start.info.run, kept.size(), mass, unit,
             kept.size() == all ? std::string()
                                : fmt::format(", {} more replaced by regions", all - kept.size()));
}

void say_counts(Case const& c, Model const& model, std::vector<Seed> const& seeds) {
  auto const counts = count_regions(c);
  std::vector<double> masses(c.regions.size(), 0.0);
  for (Seed const& seed : seeds) masses[seed.region] += seed.mass;
  constexpr std::array units{"kg/m^2", "kg/m", "kg"};
  std::string const unit = units[static_cast<std::size_t>(c.dimension - 1)];
  if (!c.start.run.empty()) say_start_counts(c, unit);
  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    std::string replaced;
    if (counts[i].replaced > 0)
      replaced = fmt::format(", {} more replaced by later regions", counts[i].replaced);
    fmt::print("region {}: {} particles, {:.6g} {}{}\n", c.regions[i].name, counts[i].particles,
               masses[i], unit, replaced);
    say_bodies({c.regions[i].shape, c.regions[i].plus, c.regions[i].minus}, c.regions[i].name);
  }
  fmt::print("walls: {} particles\n", model.particles.range(Kind::wall).size());
}

}  // namespace

int preview_case(PreviewOptions const& options) {
  Case c = read_case(options.case_file);
  read_start(c);
  std::filesystem::path const folder = options.output.empty()
                                           ? default_folder(options.case_file)
                                           : std::filesystem::path(options.output);
  check_folder(folder);
  Model model = build_model(c);
  add_pressure(model);
  std::vector<Seed> const seeds = fill_regions(c);
  say_counts(c, model, seeds);
  add_faces(model);
  write_vtp(folder / "particles.vtp", model.particles, Kind::fluid, 0.0);
  fmt::print("{}\n", (folder / "particles.vtp").string());
  if (model.particles.range(Kind::wall).size() > 0) {
    write_vtp(folder / "walls.vtp", model.particles, Kind::wall, 0.0);
    fmt::print("{}\n", (folder / "walls.vtp").string());
  }
  if (ParticleStore const probes = probes_of(c); probes.size() > 0) {
    write_vtp(folder / "probes.vtp", probes, Kind::fluid, 0.0);
    fmt::print("{}\n", (folder / "probes.vtp").string());
  }
  plot_preview(preview_of(c, model, seeds), folder / "preview.png");
  fmt::print("{}\n", (folder / "preview.png").string());
  return ExitCode::done;
}

}  // namespace moraine
