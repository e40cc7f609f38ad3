// Any text as a table of a run: refused with a reason, or drawn.
#include <stdexcept>

#include "fuzzing.hpp"
#include "output/plot/plot.hpp"
#include "output/table_csv.hpp"

using namespace moraine;

namespace {

/// Pictures refuse tables that lack what they show.
template <class Draw>
void draw_or_refuse(Draw draw) {
  try {
    draw();
  } catch (std::runtime_error const& error) {
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  static fuzzing::Folder const folder;
  auto const file = folder.write("gauges.csv", fuzzing::text_of(data, size));
  try {
    Table const table = read_table_csv(file);
    fuzzing::require(table.columns.size() == table.values.size(), "a list for each column");
    for (auto const& values : table.values)
      fuzzing::require(values.size() == table.rows(), "columns of one length");
    if (table.columns.size() > 40) return 0;  // pictures of many panels take long
  } catch (std::runtime_error const& error) {
    fuzzing::require(error.what()[0] != '\0', "a refusal has a reason");
    return 0;
  }
  draw_or_refuse([&] { plot_histories(file, folder / "histories.svg"); });
  draw_or_refuse([&] { plot_sums(file, folder / "sums.svg"); });
  return 0;
}
