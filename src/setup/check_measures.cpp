#include "setup/check_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/input_error.hpp"
#include "probes/particle_formula.hpp"
#include "setup/geometry.hpp"
#include "setup/parameter.hpp"
#include "setup/upward.hpp"

namespace moraine {
namespace {

class MeasureCheck {
 public:
  MeasureCheck(Case const& c, GaugeSpec const& gauge, std::string const& key, Source& source)
      : case_(c), probe_(gauge.probe), name_(gauge.name), key_(key + '.'), source_(source) {}

  void check(GaugeKind kind) {
    check_materials();
    if (source_.good(key_ + "within.min") && source_.good(key_ + "within.max"))
      check_corners(probe_.within.min, probe_.within.max, "within.max");
    if (kind == GaugeKind::crater || kind == GaugeKind::deposit || kind == GaugeKind::rise)
      check_up();
    if (kind == GaugeKind::crater) check_dimension("a crater");
    if (kind == GaugeKind::deposit) check_deposit();
    if (kind == GaugeKind::expression) check_expression();
    if (kind == GaugeKind::plane) check_plane();
  }

  void check_places(GaugeKind kind) {
    if (kind == GaugeKind::crater) check_center();
    if (kind == GaugeKind::plane)
      for (auto const& [corner, name] :
           {std::pair(probe_.plane.min, "plane.min"), std::pair(probe_.plane.max, "plane.max")})
        if (source_.good(key_ + name) &&
            !is_inside({corner, corner}, case_.domain, case_.dimension))
          source_.report_value(key_ + name, "is outside the domain");
    if (probe_.within.given && source_.good(key_ + "within.min") &&
        source_.good(key_ + "within.max"))
      check_overlap();
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(case_.dimension); }

  void check_materials() {
    std::string const key = key_ + "materials";
    if (!source_.good(key)) return;
    std::vector<std::string_view> names;
    for (MaterialSpec const& material : case_.materials) names.push_back(material.name);
    if (probe_.materials.empty())
      return source_.report_value(key, "is empty", "name at least one material");
    for (std::string const& material : probe_.materials)
      if (std::find(names.begin(), names.end(), material) == names.end())
        source_.report_value(
            key, fmt::format("holds \"{}\", which is not a material of this case", material),
            name_hint(material, names));
  }

  void check_corners(Vec3 const& min, Vec3 const& max, std::string const& max_key) {
    for (std::size_t axis = 0; axis < axes(); ++axis)
      if (!(min[axis] < max[axis]))
        source_.report_value(key_ + max_key,
                             fmt::format("must be greater than min along {}", axis_names[axis]));
  }

  void check_up() {
    if (side_above(case_, probe_.up) || source_.has_problem("physics.gravity")) return;
    source_.report_key(key_ + "up", source_.place_of(key_.substr(0, key_.size() - 1)),
                       "is missing: gravity points along no axis", "give up = \"y+\", for example");
  }

  void check_dimension(std::string_view what) {
    if (case_.dimension == 1)
      source_.report_value(key_ + "kind", fmt::format("is {}, which 1D does not have", what),
                           "compute in 2D or 3D");
  }

  void check_deposit() {
    auto const& along = probe_.deposit.along;
    auto const up = side_above(case_, probe_.up);
    if (along && up && *along / 2 == *up / 2 && source_.good(key_ + "deposit.along"))
      source_.report_value(key_ + "deposit.along", "is vertical",
                           fmt::format("heights are counted along {}; choose another axis",
                                       side_names[static_cast<std::size_t>(*up)]));
    if (along || probe_.deposit.origin || source_.has_problem(key_ + "deposit.along") ||
        source_.has_problem(key_ + "deposit.origin"))
      return;
    source_.report_key(key_ + "deposit.origin", source_.place_of(key_.substr(0, key_.size() - 1)),
                       "is missing: the run-out needs a direction, or a place to be counted from",
                       "give deposit.along or deposit.origin");
  }

  void check_expression() {
    std::string const weight = key_ + "weight";
    if (probe_.expression.reduce != Reduction::mean && source_.good(weight) &&
        source_.good(key_ + "reduce"))
      source_.report_value(weight, "has no effect: only a mean has weights", "leave it out");
    if (source_.good(key_ + "unit") &&
        probe_.expression.unit.find_first_of(",[]\"\n\r") != std::string::npos)
      source_.report_value(key_ + "unit", "cannot stand in the head of a table",
                           "leave out commas, brackets and quotes");
    std::string const key = key_ + "formula";
    if (!source_.good(key)) return;
    std::string const& text = probe_.expression.formula;
    if (auto const unknown = unknown_name(text)) {
      auto const known = known_names();
      std::string_view const near = nearest_name(unknown->name, known);
      std::string const fields =
          fmt::format("fields are {}", fmt::join(particle_variables(), ", "));
      return source_.report_value(
          key,
          fmt::format("has \"{}\" at position {}, which is no field of a particle and no function",
                      unknown->name, unknown->position),
          near.empty() ? fields : fmt::format("did you mean \"{}\"?", near));
    }
    if (std::string const fault = formula_fault(text); !fault.empty())
      source_.report_value(key, fmt::format("is no formula: {}", fault),
                           "write operators + - * / ^, functions and fields, as in "
                           "\"pressure * volume\"");
  }

  void check_plane() {
    if (case_.dimension == 1) return check_dimension("a plane");
    for (char const letter : name_)
      if (!(std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' ||
            letter == '-') &&
          source_.good(key_ + "name"))
        return source_.report_value(key_ + "name",
                                    "names files and may hold letters, digits, - and _ only");
    for (auto const* part : {"plane.min", "plane.max", "plane.step"})
      if (!source_.good(key_ + part)) return;
    auto const& [min, max, step] = probe_.plane;
    std::size_t flat = 0;
    double points = 1.0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      if (min[axis] > max[axis])
        return source_.report_value(key_ + "plane.max",
                                    fmt::format("is below min along {}", axis_names[axis]));
      flat += min[axis] == max[axis] ? 1U : 0U;
      points *= std::ceil((max[axis] - min[axis]) / step) + 1.0;
    }
    if (flat != axes() - 2)
      source_.report_value(
          key_ + "plane.max",
          case_.dimension == 3
              ? fmt::format("agrees with min along {} axes; it must along one", flat)
              : std::string("must be greater than min along both axes"));
    else if (points > most_points)
      source_.report_value(
          key_ + "plane.step",
          fmt::format("makes {:.3g} points; {:.0e} are possible", points, most_points));
  }

  void check_center() {
    std::string const key = key_ + "crater.center";
    auto const up = side_above(case_, probe_.up);
    if (!source_.good(key) || !up) return;
    Point plan = probe_.crater.center;
    auto const axis = static_cast<std::size_t>(*up / 2);
    plan[axis] = case_.domain.min[axis];
    if (!is_inside({plan, plan}, case_.domain, case_.dimension))
      source_.report_value(key, "is outside the domain");
    auto const& [low, high] = std::pair(case_.domain.min[axis], case_.domain.max[axis]);
    double const level = probe_.crater.level * (*up % 2 == 1 ? 1.0 : -1.0);
    if (source_.good(key_ + "crater.level") && (level < low || level > high))
      source_.report_value(key_ + "crater.level", "is outside the domain");
  }

  void check_overlap() {
    for (std::size_t axis = 0; axis < axes(); ++axis)
      if (probe_.within.max[axis] <= case_.domain.min[axis] ||
          probe_.within.min[axis] >= case_.domain.max[axis])
        return source_.report_value(key_ + "within.max", "makes a box outside the domain");
  }

  static constexpr double most_points = 1e7;
  Case const& case_;
  ProbeSpec const& probe_;
  std::string const& name_;
  std::string key_;
  Source& source_;
};

}  // namespace

void check_measure(Case const& c, GaugeSpec const& gauge, std::string const& key, Source& source) {
  MeasureCheck(c, gauge, key, source).check(gauge.kind);
}

void check_measure_places(Case const& c, GaugeSpec const& gauge, std::string const& key,
                          Source& source) {
  MeasureCheck(c, gauge, key, source).check_places(gauge.kind);
}

}  // namespace moraine
