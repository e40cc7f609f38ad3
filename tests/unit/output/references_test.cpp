// Reference values and curves of a case: what is read, and every mistake with its message.
#include "output/references.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// `reference` begins on line 17.
std::string text_of(std::string const& reference, std::string const& output = "") {
  return "[space]\ndimension = 2\n[resolution]\nspacing = 0.1\n[time]\nend = 1\n"
         "[material.water]\neos = \"tait\"\n[[region]]\nname = \"pool\"\nmaterial = \"water\"\n"
         "box = { min = [0, 0], max = [2, 1] }\n[[gauge]]\nname = \"bed\"\nposition = [1, 0.2]\n"
         "[[reference]]\nname = \"r\"\n" +
         reference + output;
}

class References : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("curve.csv"), "time [s],pressure [Pa]\n0,1\n2,3\n");
    write(path("one.csv"), "time\n0\n");
    write(path("back.csv"), "time,p\n1,0\n0,1\n");
  }
  Case read(std::string const& text) const { return parse_case(text, path("case.toml").string()); }
  /// The message without the folder.
  std::string error_of(std::string const& text) const {
    std::string message = message_of<InputErrors>([&] { check_references(read(text)); });
    std::string const folder = path("").string();
    for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }
};

TEST_F(References, BelongToColumnsOfTheirGauges) {
  Case const c =
      read(text_of("gauge = \"bed\"\ncolumn = \"velocity_y\"\nmeasure = \"smallest\"\n"
                   "value = -1\nsource = \"a book\"\n"
                   "[[reference]]\nname = \"curve\"\ngauge = \"bed\"\n"
                   "file = \"curve.csv\"\nsource = \"a book\"\n"));
  check_references(c);
  EXPECT_EQ(column_of(c, c.references[0]).name, "bed velocity_y");
  EXPECT_EQ(column_of(c, c.references[0]).unit, "m/s");
  EXPECT_EQ(column_of(c, c.references[1]).name, "bed pressure") << "the first";
  EXPECT_EQ(read_reference_curve(c.references[1].file).value, (std::vector<double>{1.0, 3.0}));
  Case const again = read(used_case(c));
  EXPECT_EQ(again.references[0].measure, ReadingMeasure::smallest);
  EXPECT_EQ(again.references[0].value, -1.0);
  EXPECT_EQ(again.references[1].file, c.references[1].file);
}

TEST_F(References, HaveMistakesThatAreTold) {
  struct Bad {
    char const *reference, *output, *message;
  };
  for (
      auto const& [reference, output, message] : {
          Bad{"gauge = \"bad\"\nvalue = 1\nsource = \"s\"", "",
              "case.toml:18:9: reference.r.gauge: \"bad\" is not a gauge of this case; did you "
              "mean \"bed\"?"},
          Bad{"gauge = \"bed\"\nsource = \"s\"", "",
              "case.toml:16:1: reference.r: has neither value nor file; give one of the two"},
          Bad{"gauge = \"bed\"\nvalue = 1\nfile = \"curve.csv\"\nsource = \"s\"", "",
              "case.toml:19:9: reference.r.value: 1 is given together with file; leave out one of "
              "the two"},
          Bad{"gauge = \"bed\"\ntolerance = 0.1\nfile = \"curve.csv\"\nsource = \"s\"", "",
              "case.toml:19:13: reference.r.tolerance: 0.1 belongs to a value, not to a curve; "
              "leave it out"},
          Bad{"gauge = \"bed\"\nvalue = 0\ntolerance = 0.1\nsource = \"s\"", "",
              "case.toml:20:13: reference.r.tolerance: 0.1 is a share of a value that is zero; "
              "give "
              "within, in the unit of the value"},
          Bad{"gauge = \"bed\"\nvalue = 1\ntolerance = 0.1\nwithin = 0.1\nsource = \"s\"", "",
              "case.toml:21:10: reference.r.within: 0.1 is given together with tolerance; leave "
              "out "
              "one of the two"},
          Bad{"gauge = \"bed\"\nfile = \"none.csv\"\nsource = \"s\"", "",
              "case.toml:19:8: reference.r.file: \"none.csv\" is no file: there is no none.csv"},
          Bad{"gauge = \"bed\"\nvalue = 1\nmeasure = \"arrival\"\nsource = \"s\"", "",
              "case.toml:20:11: reference.r.measure: \"arrival\" is not known: nothing says what "
              "an "
              "arrival is; give output.arrival_pressure"},
          Bad{"gauge = \"bed\"\nvalue = 1\nmeasure = \"arrival\"\ncolumn = \"density\"\n"
              "source = \"s\"",
              "\n[output]\narrival_pressure = 1",
              "case.toml:20:11: reference.r.measure: \"arrival\" is told of pressures; bed density "
              "is in kg/m^3"},
          Bad{"gauge = \"bed\"\nvalue = 1\ncolumn = \"presure\"\nsource = \"s\"", "",
              "case.toml:20:10: reference.r.column: \"presure\" is no column of gauge \"bed\"; did "
              "you mean \"pressure\"?"},
          Bad{"gauge = \"bed\"\nfile = \"one.csv\"\nsource = \"s\"", "",
              "case.toml:19:8: reference.r.file: \"one.csv\" has less than two columns"},
          Bad{"gauge = \"bed\"\nfile = \"back.csv\"\nsource = \"s\"", "",
              "case.toml:19:8: reference.r.file: \"back.csv\" has times that are not in ascending "
              "order"},
          Bad{"gauge = \"bed\"\nvalue = 1", "",
              "case.toml:16:1: reference.r.source: is missing: where the value or curve "
              "comes from"},
      })
    EXPECT_EQ(error_of(text_of(reference, output)), message);
}

}  // namespace
}  // namespace moraine
