#include "output/sloshing/tank_pictures.hpp"

#include "output/motion/common_times.hpp"
#include "output/plot/stacked_panels.hpp"

namespace moraine {

void draw_tank_responses(std::filesystem::path const& out,
                         std::vector<TankResponse> const& responses) {
  std::vector<plot::CurvePanel> panels{
      {"acceleration", "g", {}}, {"surface at +x wall", "m", {}}, {"force on tank", "N", {}}};
  std::vector<GroundRecord> records;
  for (TankResponse const& response : responses) records.push_back(response.ground);
  std::vector<double> const times = common_times(records);
  for (TankResponse const& r : responses) {
    std::string const& name = r.ground.name;
    panels[0].curves.push_back({name, at_times(r.ground, in_g(r.ground.acceleration), times)});
    panels[1].curves.push_back({name, at_times(r.ground, r.surface, times)});
    panels[2].curves.push_back({name, at_times(r.ground, r.force, times)});
  }
  plot::draw_stacked_panels(out, "Rigid tank, linear theory", {"time", times}, "s", panels);
}

}  // namespace moraine
