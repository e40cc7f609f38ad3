// `explain`, the reference page and the schema: from the table, complete, and up to date.
#include "setup/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "base/input_error.hpp"
#include "setup/explain_step.hpp"
#include "setup/json_schema.hpp"
#include "setup/parameter_table.hpp"
#include "setup/parameter_text.hpp"
#include "setup/toml.hpp"
#include "setup/value_reader.hpp"
#include "step/simulation.hpp"
#include "support/places.hpp"
#include "unit/output/scratch_folder.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

class Docs : public ScratchFolder {};

TEST_F(Docs, ReferencePageIsUpToDate) {
  EXPECT_EQ(bytes_of(source_folder() + "/docs/reference.md"), reference_page())
      << "make it with: build/moraine explain --reference > docs/reference.md";
}

TEST_F(Docs, SchemaIsUpToDate) {
  EXPECT_EQ(bytes_of(source_folder() + "/docs/moraine.schema.json"), json_schema())
      << "make it with: build/moraine schema > docs/moraine.schema.json";
}

TEST(ShippedCases, NameTheSchema) {
  for (auto const& shipped : shipped_cases())
    EXPECT_TRUE(shipped.text.starts_with("#:schema ../../docs/moraine.schema.json\n"))
        << shipped.name;
}

TEST(Explain, TellsAllOfAKey) {
  EXPECT_EQ(explain("resolution.spacing"),
            "resolution.spacing\n"
            "  distance of neighbouring particles on the initial lattice; their volume is "
            "spacing^dimension\n"
            "  unit     m (also \"cm\", \"mm\", \"km\")\n"
            "  default  none, must be given\n"
            "  range    greater than 0 m\n"
            "  example  resolution.spacing = \"1 cm\"\n");
  EXPECT_EQ(explain("material.tnt.omega"), explain("material.omega"));
  EXPECT_NE(explain("material.NAME.omega").find("where    eos = \"jwl\""), std::string::npos);
  EXPECT_EQ(explain("region[2].velocity"), explain("region.velocity"));
}

TEST(Explain, ListsTheKeysOfATable) {
  std::string const text = explain("time");
  for (auto const* key : {"time.end", "time.courant", "time.max_step", "time.fixed_step"})
    EXPECT_NE(text.find(key), std::string::npos);
  EXPECT_EQ(text.find("resolution.spacing"), std::string::npos);
  std::string const all = explain("");
  for (auto const* parameter : all_parameters())
    EXPECT_NE(all.find(full_key(*parameter)), std::string::npos) << full_key(*parameter);
}

TEST(Explain, NamesTheNearestKey) {
  EXPECT_EQ(message_of<InputErrors>([] { explain("resolution.spacng"); }),
            "moraine explain: \"resolution.spacng\" is no key of a case file; did you mean "
            "\"resolution.spacing\"?");
  EXPECT_EQ(message_of<InputErrors>([] { explain("courant"); }),
            "moraine explain: \"courant\" is no key of a case file; did you mean "
            "\"time.courant\"?");
  EXPECT_EQ(message_of<InputErrors>([] { explain("resolutoin"); }),
            "moraine explain: \"resolutoin\" is no key of a case file; did you mean "
            "\"resolution\"?");
  EXPECT_EQ(message_of<InputErrors>([] { explain("colour.of.paint"); }),
            "moraine explain: \"colour.of.paint\" is no key of a case file; moraine explain lists "
            "all keys");
}

TEST(Explain, EveryExampleIsValid) {
  for (auto const* parameter : all_parameters()) {
    std::string const example = example_value(*parameter);
    // Lists of shapes are read by the reader of whole regions.
    if (example.empty() || parameter->type == ValueType::shapes) continue;
    std::string const text = "value = " + example;
    Source source(text, "example");
    auto const table = toml::parse(text);
    EXPECT_TRUE(read_value(*table.get("value"), *parameter, 2, "value", source).has_value())
        << full_key(*parameter) << ": " << example;
  }
}

TEST(ExplainStep, ListsTheActionsInOrder) {
  std::string const text = explain_step(shipped_case("tnt-in-water"));
  std::size_t place = 0;
  for (auto const& [label, description] : Simulation::actions()) {
    place = text.find(std::string(label) + ": " + std::string(description), place);
    ASSERT_NE(place, std::string::npos) << label;
  }
  EXPECT_NE(text.find("water: water_polynomial, tnt: jwl"), std::string::npos) << text;
  EXPECT_NE(text.find("artificial viscosity (alpha 1, beta 10)"), std::string::npos);
  EXPECT_NE(text.find("no gravity"), std::string::npos);
  EXPECT_EQ(text.find("density diffusion"), std::string::npos);
  EXPECT_NE(explain_step(shipped_case("dam-break-2d")).find("density diffusion (0.1)"),
            std::string::npos);
}

TEST(Schema, SaysWhatTheTableSays) {
  auto const schema = nlohmann::json::parse(json_schema());
  EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema.at("additionalProperties"), false);
  auto const& resolution = schema.at("properties").at("resolution");
  EXPECT_EQ(resolution.at("required"), nlohmann::json({"spacing"}));
  auto const& factor = resolution.at("properties").at("smoothing_factor");
  EXPECT_EQ(factor.at("default"), 1.2);
  auto const all = all_parameters();
  auto const entry = std::find_if(all.begin(), all.end(), [](Parameter const* parameter) {
    return parameter->key == "resolution.smoothing_factor";
  });
  ASSERT_NE(entry, all.end());
  EXPECT_EQ(factor.at("anyOf")[0].at("minimum"), (*entry)->limits.min);
  EXPECT_EQ(factor.at("anyOf")[0].at("maximum"), (*entry)->limits.max);
  EXPECT_EQ(resolution.at("properties").at("lattice").at("enum"),
            nlohmann::json({"square", "hexagonal"}));
}

}  // namespace
}  // namespace moraine
