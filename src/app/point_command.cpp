#include "app/point_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/commands.hpp"
#include "app/exact_profile.hpp"
#include "app/unit_options.hpp"
#include "base/input_error.hpp"
#include "matter/point/load_path.hpp"
#include "output/plot/stacked_panels.hpp"
#include "output/table_csv.hpp"
#include "setup/check_strength.hpp"
#include "setup/materials.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr char const* command_name = "moraine point";

constexpr char const* examples =
    R"(Paths: hydrostatic (compressed alike along all axes), uniaxial (along x, no strain across),
triaxial (along x, the stress across is held), biaxial (along x, the stress along y is held, plane
strain), shear (simple shear at constant volume). Adiabatic, with the equation of state and the
strength that a run would have.

Examples:
  moraine point sand_loose --path triaxial --confinement "100 kPa" --strain 0.2
  moraine point sand_dense --path uniaxial --strain 0.3 --csv - > oedometer.csv
  moraine point soil --case my-case/case.toml --path shear --confinement "1 MPa" --plot shear.svg
)";

[[noreturn]] void refuse(std::string key, std::string value, std::string rule, std::string hint) {
  throw InputErrors(
      {{command_name, 0, 0, std::move(key), std::move(value), std::move(rule), std::move(hint)}});
}

MaterialSpec material_of(PointOptions const& options) {
  if (options.case_file.empty()) return shipped_material(options.material).spec;
  Case const c = read_case(options.case_file);
  std::vector<std::string_view> names;
  for (MaterialSpec const& material : c.materials) {
    if (material.name == options.material) return material;
    names.push_back(material.name);
  }
  refuse("", fmt::format("\"{}\"", options.material), "is no material of this case",
         name_hint(options.material, names));
}

Loading loading_of(PointOptions const& options) {
  UnitOptions input(command_name);
  Loading loading;
  auto const found =
      std::find(load_path_names.begin(), load_path_names.end(), std::string_view(options.path));
  if (found == load_path_names.end())
    input.mistake("--path", fmt::format("\"{}\"", options.path), "is no path",
                  name_hint(options.path, {load_path_names.begin(), load_path_names.end()}));
  else
    loading.path = static_cast<LoadPath>(found - load_path_names.begin());
  if (auto const p = input.not_negative("--confinement", options.confinement, Quantity::pressure))
    loading.confinement = *p;
  bool const extends = options.strain.starts_with('-');
  if (auto const strain =
          input.positive("--strain", options.strain.substr(extends ? 1 : 0), Quantity::number))
    loading.strain = extends ? -*strain : *strain;
  if (loading.path != LoadPath::shear && std::fabs(loading.strain) > 1.0)
    input.mistake("--strain", options.strain, "must not be more than 1 (logarithmic)");
  loading.steps = options.steps;
  input.raise();
  return loading;
}

Table table_of_states(std::vector<ElementState> const& states, LoadPath path) {
  bool const shears = path == LoadPath::shear;
  Table table = table_of({{shears ? "shear" : "strain", ""},
                          {"density", "kg/m^3"},
                          {"pressure", "Pa"},
                          {"stress_xx", "Pa"},
                          {"stress_yy", "Pa"},
                          {"stress_zz", "Pa"},
                          {"stress_xy", "Pa"},
                          {"shear_stress", "Pa"},
                          {"plastic_strain", ""},
                          {"plastic_work", "J/m^3"},
                          {"specific_energy", "J/kg"}});
  for (ElementState const& state : states) {
    auto const sigma = state.stress();
    add_row(table,
            {shears ? 2.0 * state.strain[3] : -state.strain[0], state.density, state.pressure,
             sigma[0], sigma[1], sigma[2], sigma[3], shear_norm(state.shear.stress),
             state.shear.plastic_strain, state.shear.plastic_work, state.specific_energy});
  }
  return table;
}

std::string summary(MaterialSpec const& material, Loading const& loading, Table const& table) {
  std::string text =
      fmt::format("{}: eos {}, strength {}\n{} to {:g} in {} steps, from a pressure of {:g} Pa\n\n",
                  material.name, eos_name(material.eos),
                  strength_names[static_cast<std::size_t>(material.strength.kind)],
                  load_path_names[static_cast<std::size_t>(loading.path)], loading.strain,
                  loading.steps, loading.confinement);
  constexpr std::size_t shown = 11;
  for (auto const& column : table.columns) text += fmt::format("{:>16}", column.name);
  text += '\n';
  for (auto const& column : table.columns)
    text += fmt::format("{:>16}", column.unit.empty() ? "-" : column.unit);
  text += '\n';
  for (std::size_t k = 0; k < shown; ++k) {
    std::size_t const row = k * (table.rows() - 1) / (shown - 1);
    for (auto const& column : table.values) text += fmt::format("{:>16.6g}", column[row]);
    text += '\n';
  }
  return text;
}

void draw(MaterialSpec const& material, Loading const& loading, Table const& table,
          std::string const& file) {
  std::vector<plot::CurvePanel> panels{{"stress", "Pa", {}}};
  for (std::string_view const name : {"stress_xx", "stress_yy", "stress_zz", "stress_xy"})
    panels[0].curves.push_back({std::string(name), *table.find(name)});
  panels.push_back(
      {"pressure and shear stress",
       "Pa",
       {{"pressure", *table.find("pressure")}, {"sqrt(J2)", *table.find("shear_stress")}}});
  panels.push_back({"density", "kg/m^3", {{"", *table.find("density")}}});
  panels.push_back({"plastic work", "J/m^3", {{"", *table.find("plastic_work")}}});
  plot::draw_stacked_panels(
      file,
      fmt::format("{}, {}", material.name, load_path_names[static_cast<std::size_t>(loading.path)]),
      {table.columns[0].name, table.values[0]}, "", panels);
}

int run_point(PointOptions const& options) {
  if (!options.plot.empty() && !options.plot.ends_with(".svg") && !options.plot.ends_with(".png"))
    refuse("--plot", fmt::format("\"{}\"", options.plot), "is no picture that can be drawn",
           "choose a name that ends with .svg or .png");
  MaterialSpec const material = material_of(options);
  Loading const loading = loading_of(options);
  Table table;
  try {
    MaterialElement const element(material.eos, strength_of(material.strength));
    table = table_of_states(follow(element, loading), loading.path);
  } catch (std::domain_error const& error) {
    refuse("--path", fmt::format("\"{}\"", options.path), error.what(), "");
  }
  if (!options.csv.empty() && options.csv != "-") write_csv(table, options.csv);
  if (!options.plot.empty()) draw(material, loading, table, options.plot);
  fmt::print("{}", options.csv == "-" ? csv_text(table) : summary(material, loading, table));
  return ExitCode::done;
}

}  // namespace

void add_point_command(CLI::App& app, PointOptions& options) {
  auto* command = app.add_subcommand(
      "point", "what a material makes of a laboratory test: one point, no particles");
  command->add_option("material", options.material, "a shipped material, or one of the case")
      ->required();
  command->add_option("--case", options.case_file, "case file that has the material");
  command->add_option("--path", options.path, "hydrostatic, uniaxial, triaxial, biaxial or shear")
      ->capture_default_str();
  command->add_option("--confinement", options.confinement, "pressure at the start, \"100 kPa\"")
      ->capture_default_str();
  command
      ->add_option("--strain", options.strain,
                   "compression (logarithmic) or shear angle at the end; negative: extension")
      ->capture_default_str();
  command->add_option("--steps", options.steps, "steps to there")
      ->check(CLI::Range(10, 10000000))
      ->capture_default_str();
  command->add_option("--csv", options.csv, "write all steps to this file, or to the output: -");
  command->add_option("--plot", options.plot, "draw the path: a file .svg or .png");
  command->footer(examples);
}

std::optional<int> run_point_command(CLI::App const& app, PointOptions const& options) {
  if (!app.got_subcommand("point")) return std::nullopt;
  return run_point(options);
}

}  // namespace moraine
