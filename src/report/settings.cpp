#include "report/settings.hpp"

#include "setup/parameter_table.hpp"
#include "setup/settings_of.hpp"

namespace moraine::report {

Json settings_json(RunFiles const& run) {
  auto list = Json::array();
  if (!run.used_case) return list;
  for (Setting const& setting : settings_of(*run.used_case))
    list.push_back({{"section", setting.section},
                    {"key", setting.key},
                    {"value", setting.value},
                    {"unit", setting.unit},
                    {"is_default", setting.is_default},
                    {"meaning", setting.meaning}});
  return list;
}

std::string kind_name(GaugeSpec const& gauge) {
  for (auto const& entry : gauge_entries())
    if (entry.parameter.key == "kind")
      return std::string(entry.parameter.names.at(static_cast<std::size_t>(gauge.kind)));
  return {};
}

}  // namespace moraine::report
