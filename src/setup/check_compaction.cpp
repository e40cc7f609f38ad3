#include "setup/check_compaction.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string_view>
#include <utility>
#include <variant>

namespace moraine {
namespace {

class CompactionCheck {
 public:
  CompactionCheck(PAlpha const& law, std::string const& key, Source& source)
      : law_(law), key_(key), source_(source) {}

  void run() {
    bool const sound = check_solid() & check_pressures();
    if (sound && check_elastic_limit() && check_floor()) check_unloading();
  }

 private:
  bool check_solid() {
    if (!(law_.reference_density < law_.solid_density))
      return wrong(
          {"reference_density", "solid_density"},
          fmt::format("leaves no pores: the density of the porous material, {:.6g} kg/m^3, "
                      "is not below that of its solid, {:.6g} kg/m^3",
                      law_.reference_density, law_.solid_density),
          "material without pores is eos = \"us_up\"");
    if (!(law_.reference_sound_speed < law_.solid_sound_speed))
      return wrong({"reference_sound_speed", "solid_sound_speed"},
                   fmt::format("makes porous material, {:.6g} m/s, as stiff as its solid, {:.6g} "
                               "m/s",
                               law_.reference_sound_speed, law_.solid_sound_speed));
    return true;
  }

  bool check_pressures() {
    if (law_.elastic_limit < law_.full_compaction_pressure) return true;
    return wrong({"full_compaction_pressure", "elastic_limit"},
                 fmt::format("leaves nothing to be crushed: full compaction at {:.6g} Pa is not "
                             "above the elastic limit, {:.6g} Pa",
                             law_.full_compaction_pressure, law_.elastic_limit));
  }

  bool check_elastic_limit() {
    if (law_.virgin_distension() > 1.0) return true;
    return wrong({"elastic_limit", "reference_sound_speed"},
                 "lets all pores close before the elastic limit is reached",
                 "lower elastic_limit or raise reference_sound_speed");
  }

  // In tension pores grow along the elastic line; the solid must stay a part of the volume.
  bool check_floor() {
    if (law_.least_pressure > law_.largest_tension()) return true;
    return wrong({"least_pressure", "reference_sound_speed"},
                 fmt::format("is more tension than the pores can bear elastically, {:.4g} Pa",
                             law_.largest_tension()),
                 "raise least_pressure towards 0");
  }

  void check_unloading() {
    if (law_.unloads_steeply()) return;
    wrong({"reference_sound_speed", "full_compaction_pressure", "half_pressure", "crush_exponent",
           "elastic_limit"},
          fmt::format("makes unloading give back more work than crushing took: the crush curve "
                      "begins as steep as {:.4g} m/s, undisturbed material has {:.4g} m/s",
                      law_.crush_speed(), law_.reference_sound_speed),
          "raise reference_sound_speed, or lower full_compaction_pressure or half_pressure");
  }

  // Reports at the first key that the case gives, else at the material.
  bool wrong(std::initializer_list<std::string_view> keys, std::string rule,
             std::string hint = {}) {
    for (std::string_view const name : keys) {
      std::string const full = key_ + std::string(name);
      if (source_.has_problem(full)) return false;
      if (!source_.has(full)) continue;
      source_.report_value(full, std::move(rule), std::move(hint));
      return false;
    }
    std::string const choice = key_ + (source_.has(key_ + "eos") ? "eos" : "use");
    source_.report_value(choice, std::move(rule), std::move(hint));
    return false;
  }

  PAlpha const& law_;
  std::string const& key_;
  Source& source_;
};

}  // namespace

void check_compaction(MaterialSpec const& material, std::string const& key, Source& source) {
  if (source.has_problem(key + "eos") || source.has_problem(key + "use")) return;
  if (auto const* law = std::get_if<PAlpha>(&material.eos))
    CompactionCheck(*law, key, source).run();
}

}  // namespace moraine
