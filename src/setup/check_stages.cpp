#include "setup/check_stages.hpp"

#include <algorithm>
#include <string_view>

#include "base/input_error.hpp"

namespace moraine {
namespace {

class StageCheck {
 public:
  StageCheck(Case const& c, StageSpec const& stage, std::string const& key, Source& source)
      : case_(c), stage_(stage), key_(key + '.'), source_(source) {}

  void run(bool last) {
    check_name("remove_wall", stage_.remove_wall, case_.walls, "is not a wall of this case");
    check_name("detonate", stage_.detonate, case_.regions, "is not a region of this case");
    check_name("into", stage_.into, case_.materials, "is not a material of this case");
    check_together("detonate", !stage_.detonate.empty(), "into", !stage_.into.empty());
    check_until(last);
  }

 private:
  void check_until(bool last) {
    UntilSpec const& until = stage_.until;
    bool const limit = until.pressure_above || until.pressure_below;
    check_together("until.rms_speed_below", until.rms_speed_below.has_value(), "until.steady_for",
                   until.steady_for.has_value());
    check_together("until.gauge", !until.gauge.empty(), "until.pressure_above", limit);
    if (until.pressure_above && until.pressure_below)
      source_.report_value(key_ + "until.pressure_below", "is given together with pressure_above",
                           "give one of the two");
    std::vector<GaugeSpec> points;
    for (GaugeSpec const& gauge : case_.gauges)
      if (gauge.kind == GaugeKind::point) points.push_back(gauge);
    check_name("until.gauge", until.gauge, points, "is not a point gauge of this case");
    bool const ends = until.after || until.rms_speed_below || !until.gauge.empty();
    if (last && ends)
      source_.report_key(key_ + "until", {}, "has no effect: no stage follows",
                         "leave it out; the last stage goes on to time.end");
    if (!last && !ends)
      source_.report_key(key_ + "until", {}, "is missing: a stage that others follow must end",
                         "give until.after, until.rms_speed_below or until.gauge");
  }

  /// A name that is given must be that of one of the specs.
  template <class Spec>
  void check_name(std::string_view key, std::string const& name, std::vector<Spec> const& specs,
                  std::string_view rule) {
    std::string const full = key_ + std::string(key);
    if (name.empty() || !source_.good(full)) return;
    std::vector<std::string_view> names;
    for (auto const& spec : specs) names.push_back(spec.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
      source_.report_value(full, std::string(rule), name_hint(name, names));
  }

  /// Two keys of which each means nothing without the other.
  void check_together(std::string_view a, bool has_a, std::string_view b, bool has_b) {
    if (has_a == has_b) return;
    auto const& [given, missing] = has_a ? std::pair(a, b) : std::pair(b, a);
    std::string const full = key_ + std::string(given);
    if (source_.good(full))
      source_.report_value(full, "needs " + std::string(missing) + " beside it");
  }

  Case const& case_;
  StageSpec const& stage_;
  std::string key_;
  Source& source_;
};

}  // namespace

void check_stages(Case const& c, std::vector<std::string> const& keys, Source& source) {
  for (std::size_t i = 0; i < c.stages.size(); ++i)
    StageCheck(c, c.stages[i], keys[i], source).run(i + 1 == c.stages.size());
}

}  // namespace moraine
