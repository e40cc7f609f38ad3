#include "output/blast/answer_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace moraine::blast {
namespace {

/// Warnings without repetitions; their places are the marks.
class Footnotes {
 public:
  /// "[1] [3]", or nothing.
  std::string marks(std::vector<std::string> const& warnings) {
    std::string text;
    for (std::string const& warning : warnings) {
      auto place = std::ranges::find(notes_, warning);
      if (place == notes_.end()) place = notes_.insert(notes_.end(), warning);
      text += fmt::format(" [{}]", place - notes_.begin() + 1);
    }
    return text;
  }

  std::string text() const {
    std::string text;
    for (std::size_t i = 0; i < notes_.size(); ++i)
      text += fmt::format("  [{}] {}\n", i + 1, notes_[i]);
    return text.empty() ? text : "\nwarnings\n" + text;
  }

 private:
  std::vector<std::string> notes_;
};

/// A relation is not recommended where it does not hold.
std::string_view worth(Estimate const& estimate) {
  if (!std::isfinite(estimate.value)) return "no solution";
  bool const doubtful = estimate.standing == Standing::doubtful;
  return estimate.in_range || doubtful ? name_of(estimate.standing) : "outside its range";
}

std::string line(Estimate const& estimate, OutputUnits const& units, Footnotes& footnotes) {
  Measure const measure = estimate.relation->measure;
  std::string value = readable(units.shown(measure, estimate.value));
  if (estimate.low < estimate.high)
    value += fmt::format(" ({} to {})", readable(units.shown(measure, estimate.low)),
                         readable(units.shown(measure, estimate.high)));
  return fmt::format("  {:<26}{:<28} {}{}\n", estimate.relation->name, value, worth(estimate),
                     footnotes.marks(estimate.warnings));
}

/// Assumptions and corrections, each once with the names of its relations. Those of doubtful ones
/// stand in their warnings.
std::string notes_text(Answer const& answer) {
  struct Note {
    std::string_view text;
    std::vector<std::string_view> names;
  };
  std::vector<Note> notes;
  for (Estimate const& estimate : answer.estimates) {
    Relation const& relation = *estimate.relation;
    if (relation.note.empty() || estimate.standing == Standing::doubtful) continue;
    auto note = std::ranges::find(notes, relation.note, &Note::text);
    if (note == notes.end()) note = notes.insert(notes.end(), {relation.note, {}});
    if (std::ranges::find(note->names, relation.name) == note->names.end())
      note->names.push_back(relation.name);
  }
  std::string text = notes.empty() ? "" : "\nnotes\n";
  for (Note const& note : notes)
    text += fmt::format("  {}: {}\n", fmt::join(note.names, ", "), note.text);
  return text;
}

std::string spread_line(Answer const& answer, Measure measure, OutputUnits const& units) {
  auto const spread = std::ranges::find(answer.spreads, measure, &Spread::measure);
  if (spread == answer.spreads.end()) return {};
  return fmt::format("  {:<26}{} to {}, a factor of {:.2f}\n",
                     fmt::format("spread of {}", spread->count),
                     readable(units.shown(measure, spread->low)),
                     readable(units.shown(measure, spread->high)), spread->high / spread->low);
}

std::string gauge_line(Answer const& answer, Measure measure, OutputUnits const& units,
                       GaugeReadings const& gauge) {
  auto const reading = gauge.of(measure);
  if (!reading) return {};
  Estimate const* beside = yardstick(answer, measure);
  std::string const worth =
      beside == nullptr
          ? std::string("measured in the run")
          : fmt::format("{:.3f} of {}", *reading / beside->value, beside->relation->name);
  return fmt::format("  {:<26}{:<28} {}\n", "gauge " + gauge.gauge,
                     readable(units.shown(measure, *reading)), worth);
}

}  // namespace

std::string answer_text(Answer const& answer, OutputUnits const& units,
                        GaugeReadings const& gauge) {
  std::string text;
  Footnotes footnotes;
  std::optional<Measure> current;
  auto const close = [&] {
    if (!current) return;
    text += spread_line(answer, *current, units) + gauge_line(answer, *current, units, gauge);
  };
  for (Estimate const& estimate : answer.estimates) {
    Measure const measure = estimate.relation->measure;
    if (measure != current) {
      close();
      current = measure;
      text += fmt::format("\n{}\n", with_unit(info(measure).name, units.unit(measure)));
    }
    text += line(estimate, units, footnotes);
  }
  close();
  text += footnotes.text() + notes_text(answer);
  for (std::size_t i = 0; i < answer.unanswered.size(); ++i)
    text += fmt::format("{}  {} by {} needs {}\n", i == 0 ? "\nnot answered\n" : "",
                        words(info(answer.unanswered[i].relation->measure).name),
                        answer.unanswered[i].relation->name, answer.unanswered[i].needs);
  return text;
}

std::string list_text(std::span<Relation const> relations) {
  std::string text;
  std::optional<Topic> topic;
  for (Relation const& relation : relations) {
    if (topic != relation.topic) text += fmt::format("{}\n", name_of(relation.topic));
    topic = relation.topic;
    text +=
        fmt::format("  {} by {} ({})\n    {}\n    {}\n    {}\n", words(info(relation.measure).name),
                    relation.name, name_of(relation.standing), relation.formula, relation.source,
                    describe(relation.validity));
    if (!relation.note.empty()) text += fmt::format("    {}\n", relation.note);
  }
  return text;
}

}  // namespace moraine::blast
