#include "sweep/sweep_plots.hpp"

#include <gtest/gtest.h>

#include "sweep/sweep_results.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

SweepAxis axis(std::string const& label, std::vector<SweepValue> const& values) {
  SweepAxis made;
  made.columns = {{{label, Section::top, "", label, nullptr}, label, ""}};
  for (auto const& value : values) made.values.push_back({value});
  return made;
}

SweepValue number(double value) { return {std::to_string(value), value, {}}; }
SweepValue word(std::string const& value) { return {'"' + value + '"', value, {}}; }

class SweepPictures : public ScratchFolder {
 protected:
  static SweepPlan plan() {
    SweepPlan plan;
    plan.title = "pictures";
    plan.axes = {axis("spacing", {number(0.01), number(0.02)}),
                 axis("kernel", {word("lucy"), word("dome"), word("gaussian")}),
                 axis("constant", {number(1.0)})};
    plan.axes[0].logarithmic = true;
    SweepOutput output;
    output.label = "peak";
    output.unit = "Pa";
    plan.outputs = {output};
    for (auto const& a : plan.axes[0].values)
      for (auto const& b : plan.axes[1].values)
        plan.members.push_back({"m", {a[0], b[0], number(1.0)}});
    return plan;
  }
  static SweepTable table(SweepPlan const& plan) {
    SweepTable table = SweepResults(plan).table();
    for (std::size_t i = 0; i < table.members.size(); ++i) {
      table.members[i].state = SweepTable::State::done;
      table.members[i].outputs[0] = 1e6 * static_cast<double>(i + 1);
    }
    return table;
  }
};

TEST_F(SweepPictures, OneForEachParameterThatVaries) {
  auto const files = plot_sweep(plan(), table(plan()), path("plots"));
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0], path("plots/sweep_spacing.png"));
  EXPECT_EQ(files[1], path("plots/sweep_kernel.png"));
  for (auto const& file : files) EXPECT_EQ(bytes_of(file).substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST_F(SweepPictures, ShowTheScaleAndTheMembersThatAreDone) {
  auto const picture = [&](SweepPlan const& plan, SweepTable const& table) {
    return bytes_of(plot_sweep(plan, table, path("plots")).front());
  };
  std::string const full = picture(plan(), table(plan()));
  SweepPlan linear = plan();
  linear.axes[0].logarithmic = false;
  EXPECT_NE(picture(linear, table(linear)), full);
  SweepTable gap = table(plan());
  gap.members[2].state = SweepTable::State::failed;
  gap.members[2].outputs[0].reset();
  EXPECT_NE(picture(plan(), gap), full);
}

TEST_F(SweepPictures, NoneWithoutResults) {
  EXPECT_TRUE(plot_sweep(plan(), SweepResults(plan()).table(), path("plots")).empty());
  EXPECT_FALSE(std::filesystem::exists(path("plots")));
}

}  // namespace
}  // namespace moraine
