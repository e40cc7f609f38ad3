#include "report/run_json.hpp"

#include <fmt/core.h>

#include "report/comparisons.hpp"
#include "report/measures.hpp"
#include "report/quality.hpp"
#include "report/settings.hpp"

namespace moraine::report {
namespace {

/// Facts that are told only where they are known.
class Facts {
 public:
  void add(char const* label, std::string value) {
    if (!value.empty()) list_.push_back({{"label", label}, {"value", std::move(value)}});
  }
  void add(char const* label, std::optional<double> value, char const* unit) {
    if (value) add(label, fmt::format("{:.6g}{}{}", *value, *unit == '\0' ? "" : " ", unit));
  }
  Json take() { return std::move(list_); }

 private:
  Json list_ = Json::array();
};

Json facts_of(RunFiles const& run) {
  auto const& manifest = run.manifest;
  Facts facts;
  if (run.used_case) {
    Case const& c = *run.used_case;
    facts.add("dimension", fmt::format("{}D", c.dimension));
    facts.add("spacing", c.numerics.spacing, "m");
    facts.add("smoothing length", c.numerics.smoothing_length(), "m");
    facts.add("kernel", std::string(kernel_name(c.numerics.kernel)));
  }
  facts.add("particles at the start, walls included", number_at(manifest, "particles_at_start"),
            "");
  facts.add("simulated time", number_at(run.status, "time_s"), "s");
  facts.add("steps", number_at(run.status, "step"), "");
  facts.add("computing time", number_at(run.status, "wall_time_s"), "s");
  facts.add("threads", number_at(manifest, "threads"), "");
  facts.add("precision", text_at(manifest, "precision"));
  facts.add("vector instructions", text_at(manifest, "simd"));
  facts.add("started", text_at(manifest, "start_time_utc"));
  facts.add("program", fmt::format("Moraine {} ({})", text_at(manifest, "version"),
                                   text_at(manifest, "git_revision")));
  facts.add("compiler", text_at(manifest, "compiler"));
  facts.add("case file", text_at(manifest, "case_file"));
  facts.add("SHA-256 of the case file", text_at(manifest, "case_sha256"));
  return facts.take();
}

Json number_or_null(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

Json progress_of(RunFiles const& run) {
  if (state_of(run) != "running") return nullptr;
  auto const number = [&](char const* key) { return number_at(run.status, key).value_or(0.0); };
  return {{"time_s", number("time_s")},
          {"end_time_s", number("end_time_s")},
          {"step", number("step")},
          {"time_step_s", number("time_step_s")},
          {"limited_by", text_at(run.status, "limited_by")},
          {"steps_per_second", number_or_null(number_at(run.status, "steps_per_second"))},
          {"time_left_s", number_or_null(number_at(run.status, "time_left_s"))},
          {"particles", number("particles")}};
}

/// Objects of a list in the status or manifest, each made anew by `copy`.
template <class Copy>
Json list_of(nlohmann::json const& object, char const* key, Copy const& copy) {
  auto list = Json::array();
  if (object.contains(key) && object[key].is_array())
    for (auto const& item : object[key])
      if (item.is_object()) list.push_back(copy(item));
  return list;
}

Json votes_of(RunFiles const& run) {
  double steps = 0.0;
  list_of(run.status, "votes", [&](auto const& vote) {
    steps += number_at(vote, "steps").value_or(0.0);
    return Json();
  });
  return list_of(run.status, "votes", [&](auto const& vote) {
    double const own = number_at(vote, "steps").value_or(0.0);
    return Json{{"reason", text_at(vote, "reason")},
                {"steps", own},
                {"share", steps > 0.0 ? own / steps : 0.0},
                {"least_time_step_s", number_or_null(number_at(vote, "least_time_step_s"))}};
  });
}

Json timing_of(RunFiles const& run) {
  return list_of(run.status, "timing", [](auto const& timer) {
    return Json{{"label", text_at(timer, "label")},
                {"seconds", number_at(timer, "seconds").value_or(0.0)},
                {"calls", number_at(timer, "calls").value_or(0.0)}};
  });
}

Json stages_of(RunFiles const& run) {
  return list_of(run.manifest, "stages", [](auto const& stage) {
    return Json{{"name", text_at(stage, "name")},
                {"time_s", number_at(stage, "time_s").value_or(0.0)},
                {"step", number_at(stage, "step").value_or(0.0)},
                {"cause", text_at(stage, "cause")}};
  });
}

}  // namespace

Json run_head(RunFiles& run, Blocks& blocks) {
  Block curves(run.prefix + "/references");
  Json references = references_of(run, curves);  // may add notes, which quality_of tells
  if (!references.empty()) blocks.add(curves);
  std::string const title = run.used_case ? run.used_case->title : "";
  return {{"name", run.name},
          {"title", title.empty() ? run.name : title},
          {"state", state_of(run)},
          {"end_reason", end_reason(run)},
          {"progress", progress_of(run)},
          {"facts", facts_of(run)},
          {"quality", quality_of(run)},
          {"comparisons", comparisons_of(run)},
          {"stages", stages_of(run)},
          {"tables", Json::array()},
          {"references", std::move(references)},
          {"measures", measures_of(run.gauge_summary)},
          {"decays", decays_of(run.gauge_summary)},
          {"votes", votes_of(run)},
          {"timing", timing_of(run)},
          {"settings", settings_json(run)},
          {"particles", nullptr}};
}

void add_later_notes(Json& head, RunFiles const& run, std::size_t first) {
  for (std::size_t i = first; i < run.notes.size(); ++i)
    head["quality"].push_back({{"name", "files"},
                               {"verdict", verdict_name(Verdict::unknown)},
                               {"value", run.notes[i]},
                               {"limit", ""},
                               {"meaning", "The files of the run hold all of it."}});
}

}  // namespace moraine::report
