#include "report/particles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>

#include "report/outlines.hpp"
#include "report/quantised.hpp"
#include "report/settings.hpp"

namespace moraine::report {
namespace {

std::array<Interval, 3> box_of(ShownFrames const& shown, Json const& wall_boxes) {
  std::array<Interval, 3> box;
  auto const include = [&](Places const& places) {
    for (std::size_t axis = 0; axis < places.size(); ++axis)
      for (double const x : places[axis]) box[axis].include(x);
  };
  for (ShownFrame const& frame : shown.frames) include(frame.places);
  for (Places const& places : shown.walls) include(places);
  for (auto const& wall : wall_boxes)
    for (char const* const end : {"min", "max"})
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(shown.dimension); ++axis)
        box[axis].include(wall[end][axis].get<double>());
  return box;
}

Json positions_of(Places const& places, std::array<Interval, 3> const& box, Block& block) {
  auto list = Json::array();
  for (std::size_t axis = 0; axis < places.size(); ++axis)
    list.push_back(block.add_u16(quantised(places[axis], box[axis])));
  return list;
}

std::vector<std::uint8_t> categories(std::vector<double> const& values) {
  std::vector<std::uint8_t> out;
  out.reserve(values.size());
  for (double const value : values)  // 255 for what is none
    out.push_back(value >= 0.0 && value < 255.0 ? static_cast<std::uint8_t>(value) : 255);
  return out;
}

std::vector<Interval> ranges_of(ShownFrames const& shown) {
  std::vector<Interval> ranges(shown.fields.size());
  for (ShownFrame const& frame : shown.frames)
    for (std::size_t k = 0; k < ranges.size(); ++k)
      for (double const value : frame.values[k]) ranges[k].include(value);
  return ranges;
}

Json fields_of(ShownFrames const& shown, std::vector<Interval> const& ranges) {
  auto list = Json::array();
  for (std::size_t k = 0; k < shown.fields.size(); ++k)
    list.push_back({{"name", shown.fields[k].name},
                    {"unit", shown.fields[k].unit},
                    {"kind", shown.fields[k].category ? "category" : "number"},
                    {"min", ranges[k].min()},
                    {"max", ranges[k].max()}});
  return list;
}

/// Most frames have the particles of the one before: their ids are told once.
class IdBlocks {
 public:
  Json add(std::vector<std::uint32_t> const& ids, Block& block) {
    if (last_ == nullptr || *last_ != ids) numbers_ = block.add_u32(ids);
    last_ = &ids;
    return numbers_;
  }

 private:
  std::vector<std::uint32_t> const* last_ = nullptr;
  Json numbers_;
};

Json frames_of(std::string const& prefix, ShownFrames const& shown,
               std::vector<Interval> const& ranges, std::array<Interval, 3> const& box,
               Blocks& blocks) {
  auto list = Json::array();
  IdBlocks ids;
  for (std::size_t n = 0; n < shown.frames.size(); ++n) {
    ShownFrame const& frame = shown.frames[n];
    Block block(fmt::format("{}/frame-{}", prefix, n));
    Json json{{"time_s", frame.time}, {"count", frame.ids.size()}};
    json["id"] = ids.add(frame.ids, block);
    json["position"] = positions_of(frame.places, box, block);
    json["values"] = Json::array();
    for (std::size_t k = 0; k < shown.fields.size(); ++k)
      json["values"].push_back(shown.fields[k].category
                                   ? block.add_u8(categories(frame.values[k]))
                                   : block.add_u16(quantised(frame.values[k], ranges[k])));
    list.push_back(std::move(json));
    blocks.add(block);
  }
  return list;
}

Json walls_of(std::string const& prefix, std::vector<Places> const& walls,
              std::array<Interval, 3> const& box, Json boxes, Blocks& blocks) {
  if (walls.empty() && boxes.empty()) return nullptr;
  auto list = Json::array();
  for (std::size_t n = 0; n < walls.size(); ++n) {
    Block block(fmt::format("{}/walls-{}", prefix, n));
    list.push_back(
        {{"count", walls[n].front().size()}, {"position", positions_of(walls[n], box, block)}});
    blocks.add(block);
  }
  return {{"frames", std::move(list)}, {"boxes", std::move(boxes)}};
}

/// 1234567 as "1 234 567", with narrow blanks that do not break.
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, "\u202f");
  return text;
}

std::string note_of(ShownFrames const& shown) {
  std::string note;
  std::size_t const particles = shown.frames.front().ids.size();
  if (particles < shown.total)
    note = fmt::format("{} of {} particles, chosen at random", grouped(particles),
                       grouped(shown.total));
  if (shown.frames.size() < shown.frames_of)
    note += fmt::format("{}{} of {} frames", note.empty() ? "" : ", ", shown.frames.size(),
                        shown.frames_of);
  return note.empty() ? note : "Shown here: " + note + ". The files of the run hold all of them.";
}

}  // namespace

std::optional<ShownFrames> frames_for_page(RunFiles& run, ParticleBudget const& budget) {
  if (run.frames.empty()) return std::nullopt;
  try {
    return read_shown_frames(run, budget);
  } catch (std::exception const& error) {
    run.notes.push_back(fmt::format("particles are left out: {}", error.what()));
    return std::nullopt;
  }
}

Json particles_of(RunFiles const& run, ShownFrames const& shown, Blocks& blocks) {
  auto const wall_boxes = run.used_case ? wall_boxes_of(*run.used_case) : Json::array();
  auto const box = box_of(shown, wall_boxes);
  auto const ranges = ranges_of(shown);
  Json json{{"dimension", shown.dimension},
            {"spacing", run.used_case ? run.used_case->numerics.spacing : 0.0}};
  json["box"] = {{"min", {box[0].min(), box[1].min(), box[2].min()}},
                 {"max", {box[0].max(), box[1].max(), box[2].max()}}};
  json["total"] = shown.total;
  json["shown"] = shown.frames.front().ids.size();
  json["note"] = note_of(shown);
  json["fields"] = fields_of(shown, ranges);
  json["materials"] = Json::array();
  if (run.used_case)
    for (MaterialSpec const& material : run.used_case->materials)
      json["materials"].push_back(material.name);
  json["frames"] = frames_of(run.prefix, shown, ranges, box, blocks);
  json["walls"] = walls_of(run.prefix, shown.walls, box, wall_boxes, blocks);
  json["probes"] = run.used_case ? probes_of(*run.used_case) : Json::array();
  return json;
}

}  // namespace moraine::report
