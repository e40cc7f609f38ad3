#include "report/shown_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "output/vtp_reader.hpp"

namespace moraine::report {
namespace {

constexpr std::size_t fewest_frames = 20;
constexpr std::size_t most_wall_particles = 20'000;
constexpr std::size_t most_moving_wall_particles = 4'000;
constexpr std::array<char const*, 3> axes{"x", "y", "z"};

/// Tensors have fields of their own that say what matters: shear_stress, pressure.
bool is_shown(FrameArray const& array) {
  return array.name != "id" && array.name != "kind" && array.components <= 3;
}

std::vector<ShownField> fields_of(ParticleFrame const& frame) {
  std::vector<ShownField> fields;
  for (FrameArray const& array : frame.arrays) {
    if (!is_shown(array)) continue;
    if (array.components == 1) {
      fields.push_back({array.name, array.unit, array.name == "material"});
      continue;
    }
    fields.push_back({array.name == "velocity" ? "speed" : array.name + "_size", array.unit});
    for (int axis = 0; axis < frame.dimension; ++axis)
      fields.push_back({array.name + "_" + axes.at(static_cast<std::size_t>(axis)), array.unit});
  }
  return fields;
}

bool is_id(double value) { return std::isfinite(value) && value >= 0.0; }

std::uint32_t shown_id(double id) { return static_cast<std::uint32_t>(std::fmod(id, 0x1p32)); }

/// Rows of the particles that are shown, by ascending id.
std::vector<std::size_t> shown_particles(ParticleFrame const& frame, FrameArray const& ids,
                                         double share) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < frame.size; ++i)
    if (is_id(ids.values[i]) && is_in_share(shown_id(ids.values[i]), share)) rows.push_back(i);
  std::sort(rows.begin(), rows.end(),
            [&](std::size_t a, std::size_t b) { return ids.values[a] < ids.values[b]; });
  return rows;
}

std::vector<double> component(FrameArray const& array, std::size_t component,
                              std::vector<std::size_t> const& rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (std::size_t const row : rows)
    values.push_back(array.values[row * array.components + component]);
  return values;
}

std::vector<double> size_of(FrameArray const& array, std::vector<std::size_t> const& rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (std::size_t const row : rows) {
    double sum = 0.0;
    for (std::size_t c = 0; c < array.components; ++c) {
      double const value = array.values[row * array.components + c];
      sum += value * value;
    }
    values.push_back(std::sqrt(sum));
  }
  return values;
}

void add_values(ShownFrame& shown, FrameArray const& array, int dimension,
                std::vector<std::size_t> const& rows) {
  if (array.components == 1) {
    shown.values.push_back(component(array, 0, rows));
    return;
  }
  shown.values.push_back(size_of(array, rows));
  for (int axis = 0; axis < dimension; ++axis)
    shown.values.push_back(component(array, static_cast<std::size_t>(axis), rows));
}

ShownFrame shown_of(ParticleFrame const& frame, double share, std::size_t fields) {
  FrameArray const* const ids = frame.find("id");
  if (ids == nullptr) throw std::runtime_error("a frame has no ids of particles");
  auto const rows = shown_particles(frame, *ids, share);
  ShownFrame shown;
  shown.time = frame.time;
  for (std::size_t const row : rows) shown.ids.push_back(shown_id(ids->values[row]));
  for (int axis = 0; axis < frame.dimension; ++axis)
    shown.places.push_back(component(frame.points, static_cast<std::size_t>(axis), rows));
  for (FrameArray const& array : frame.arrays)
    if (is_shown(array)) add_values(shown, array, frame.dimension, rows);
  if (shown.values.size() != fields) throw std::runtime_error("frames have different fields");
  return shown;
}

std::vector<std::size_t> spread(std::size_t wanted, std::size_t count) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < wanted; ++i)
    numbers.push_back(wanted == 1 ? count - 1 : i * (count - 1) / (wanted - 1));
  return numbers;
}

std::size_t bytes_each(ShownFrames const& shown) {
  return sizeof(std::uint32_t) +
         2 * (static_cast<std::size_t>(shown.dimension) + shown.fields.size());
}

/// Places of walls of a file, thinned by share to at most `most`.
Places read_wall_places(std::filesystem::path const& file, int dimension, std::size_t most) {
  ParticleFrame const frame = read_vtp(file);
  double const share = static_cast<double>(most) / std::max(1.0, static_cast<double>(frame.size));
  Places places(static_cast<std::size_t>(dimension));
  for (std::size_t i = 0; i < frame.size; ++i)
    if (is_in_share(i, share))
      for (std::size_t axis = 0; axis < places.size(); ++axis)
        places[axis].push_back(frame.points.values[3 * i + axis]);
  return places;
}

std::vector<Places> read_walls(RunFiles const& run, ShownFrames const& shown) {
  std::vector<Places> walls;
  if (run.wall_frames.size() == run.frames.size() && !run.wall_frames.empty()) {
    for (std::size_t const number : shown.numbers)
      walls.push_back(read_wall_places(run.folder / run.wall_frames[number].file, shown.dimension,
                                       most_moving_wall_particles));
  } else if (std::filesystem::exists(run.folder / "walls.vtp")) {
    walls.push_back(
        read_wall_places(run.folder / "walls.vtp", shown.dimension, most_wall_particles));
  }
  return walls;
}

std::vector<double> at(std::vector<double> const& values, std::vector<std::size_t> const& rows) {
  std::vector<double> chosen;
  chosen.reserve(rows.size());
  for (std::size_t const row : rows) chosen.push_back(values[row]);
  return chosen;
}

ShownFrame share_of(ShownFrame const& frame, double share) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < frame.ids.size(); ++i)
    if (is_in_share(frame.ids[i], share)) rows.push_back(i);
  ShownFrame part;
  part.time = frame.time;
  for (std::size_t const row : rows) part.ids.push_back(frame.ids[row]);
  for (auto const& axis : frame.places) part.places.push_back(at(axis, rows));
  for (auto const& field : frame.values) part.values.push_back(at(field, rows));
  return part;
}

}  // namespace

Selection select(std::size_t frames, std::size_t particles, std::size_t bytes_each,
                 std::size_t bytes, std::size_t most_particles) {
  double const places = static_cast<double>(bytes) / static_cast<double>(bytes_each);
  double const all = static_cast<double>(particles);
  double const shown = std::min(all, static_cast<double>(most_particles));
  if (shown <= 0.0 || frames == 0) return {frames, 1.0};
  double const fit = std::floor(places / shown);
  Selection selection;
  selection.frames =
      std::min(frames, std::max(static_cast<std::size_t>(fit), std::min(fewest_frames, frames)));
  double const in_each = std::min(shown, places / static_cast<double>(selection.frames));
  selection.share = std::min(1.0, in_each / all);
  return selection;
}

bool is_in_share(std::uint64_t id, double share) {
  if (share >= 1.0) return true;
  // The finaliser of SplitMix64 (Steele, Lea & Flood 2014): every bit of the id moves every bit.
  std::uint64_t x = id + 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  x ^= x >> 31U;
  return static_cast<double>(x >> 11U) * 0x1.0p-53 < share;
}

ShownFrames read_shown_frames(RunFiles const& run, ParticleBudget const& budget) {
  ShownFrames shown;
  shown.frames_of = run.frames.size();
  ParticleFrame first = read_vtp(run.folder / run.frames.front().file);
  shown.dimension = first.dimension;
  shown.total = first.size;
  shown.fields = fields_of(first);
  Selection const selection =
      select(run.frames.size(), first.size, bytes_each(shown), budget.bytes, budget.most_particles);
  shown.numbers = spread(selection.frames, run.frames.size());
  for (std::size_t const number : shown.numbers) {
    ParticleFrame const frame =
        number == 0 ? std::move(first) : read_vtp(run.folder / run.frames[number].file);
    shown.frames.push_back(shown_of(frame, selection.share, shown.fields.size()));
  }
  shown.walls = read_walls(run, shown);
  return shown;
}

ShownFrames thinned(ShownFrames shown, ParticleBudget const& budget) {
  Selection const selection =
      select(shown.frames_of, shown.total, bytes_each(shown), budget.bytes, budget.most_particles);
  bool const walls_move = shown.walls.size() == shown.frames.size() && shown.walls.size() > 1;
  auto const kept = spread(std::min(selection.frames, shown.frames.size()), shown.frames.size());
  std::vector<ShownFrame> frames;
  std::vector<Places> walls;
  std::vector<std::size_t> numbers;
  for (std::size_t const i : kept) {
    frames.push_back(share_of(shown.frames[i], selection.share));
    numbers.push_back(shown.numbers[i]);
    if (walls_move) walls.push_back(std::move(shown.walls[i]));
  }
  shown.frames = std::move(frames);
  shown.numbers = std::move(numbers);
  if (walls_move) shown.walls = std::move(walls);
  return shown;
}

}  // namespace moraine::report
