#include "sweep/sweep_page.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "output/run_folder.hpp"
#include "report/report.hpp"
#include "sweep/sweep_table.hpp"

namespace moraine {

bool holds_a_sweep(std::filesystem::path const& folder) {
  return std::filesystem::exists(folder / "sweep.json");
}

void write_sweep_page(std::filesystem::path const& folder, std::filesystem::path const& page,
                      std::string const& title) {
  SweepTable table = read_sweep_table(folder);
  auto const places = member_folders(table, folder);
  std::vector<std::filesystem::path> runs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    table.members[i].run.reset();
    if (!holds_a_run(places[i])) continue;
    table.members[i].run = runs.size();
    runs.push_back(places[i]);
  }
  report::write_report(
      runs,
      {.file = page, .title = title.empty() ? table.title : title, .sweep = sweep_json(table, {})});
}

}  // namespace moraine
