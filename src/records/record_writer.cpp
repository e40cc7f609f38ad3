#include "records/record_writer.hpp"

#include <fmt/format.h>

#include <iterator>

#include "base/gravity.hpp"

namespace moraine {

std::string record_as_csv(GroundRecord const& record) {
  std::string text = fmt::format("# {}\ntime [s],acceleration [m/s^2]\n", record.name);
  for (std::size_t i = 0; i < record.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", record.time(i), record.acceleration[i]);
  return text;
}

std::string record_as_at2(GroundRecord const& record) {
  std::string text = fmt::format(
      "GROUND MOTION RECORD\n{}\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= {}, DT= {} SEC\n",
      record.name, record.size(), record.time_step);
  for (std::size_t i = 0; i < record.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{:16.7E}{}",
                   record.acceleration[i] / standard_gravity,
                   i % 5 == 4 || i + 1 == record.size() ? "\n" : "");
  return text;
}

std::string displacement_as_csv(GroundRecord const& record, std::string const& axis) {
  GroundPath const path = integrate(record);
  std::string text = fmt::format("# displacement of {}, in s and m\ntime,{}\n", record.name, axis);
  for (std::size_t i = 0; i < record.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", record.time(i), path.displacement[i]);
  return text;
}

}  // namespace moraine
