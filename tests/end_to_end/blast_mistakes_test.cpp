// `moraine blast`: what it refuses, and what it says then.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "end_to_end/blast_command.hpp"
#include "output/table_csv.hpp"

namespace moraine {
namespace {

TEST_F(BlastCommand, TellsAllMistakesAtOnceAndWritesNothing) {
  CommandResult const result = call(
      "blast air --charge \"10 s\" --distance \"-5 m\" --explosive tnd --units metrc "
      "--pressure-unit m --csv a.csv --plott a.svg");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(
      result.err,
      "moraine blast air: \"--plott\" is not an option; did you mean \"--plot\"?\n"
      "moraine blast air: \"a.svg\" is not an option; see --help\n"
      "moraine blast air: --charge: \"10 s\" is a time; a mass is expected (kg)\n"
      "moraine blast air: --distance: \"-5 m\" must be above zero\n"
      "moraine blast air: --explosive: \"tnd\" is not in the list; did you mean \"tnt\"?\n"
      "moraine blast air: --units: \"metrc\" is not a system of units; did you mean "
      "\"metric\"?\n"
      "moraine blast air: --pressure-unit: \"m\" is a length; a pressure is expected (Pa)\n"
      "moraine blast air: --csv: needs a range of values; add --distances FIRST LAST COUNT\n");
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

struct Mistake {
  char const* line;
  char const* message;
};

TEST_F(BlastCommand, SaysWhatIsWrong) {
  for (auto const& [line, message] : {
           Mistake{"blast air --distance \"5 m\"",
                   "moraine blast air: --charge: is missing: mass of the charge; give a mass\n"},
           Mistake{"blast watr",
                   "moraine blast: \"watr\" is not a topic; did you mean \"water\"?\n"},
           Mistake{"blast air --charge 10 --distance \"5 m\"",
                   "moraine blast air: --charge: \"10\" is a plain number; a mass is expected "
                   "(kg); write \"10 kg\"\n"},
           Mistake{"blast air --charge \"1 kg\" --distance \"1 m\" --distances \"1 m\" \"2 m\" 5",
                   "moraine blast air: --distance: \"1 m\" and --distances exclude each other\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"5 m\" \"1 m\" 5",
                   "moraine blast air: --distances: \"1 m\" must be above the first value\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 1",
                   "moraine blast air: --distances: \"1\" is not a number of points from 2 to "
                   "10000\n"},
           Mistake{"blast reflection",
                   "moraine blast reflection: --pressure: is missing: overpressure of the incident "
                   "front or peak of the pulse; give a pressure, or --charge and --distance\n"},
           Mistake{"blast reflection --pressure \"1 bar\" --angle \"90 deg\"",
                   "moraine blast reflection: --angle: \"90 deg\" must be at least 0 and below 90 "
                   "deg\n"},
           Mistake{"blast buried --charge \"1 kg\" --distance \"2 m\" --soil loma --coupling 1.2",
                   "moraine blast buried: --coupling: \"1.2\" must be above 0 and at most 1\n"
                   "moraine blast buried: --soil: \"loma\" is not in the list; did you mean "
                   "\"loam\"?\n"},
           Mistake{"blast buried --charge \"1 kg\" --distance \"2 m\" --soil loam --depth \"1 cm\"",
                   "moraine blast buried: --coupling: is missing: the depth is 0.0252 ft/lb^(1/3), "
                   "below 2; give a number of at most 1\n"},
           Mistake{"blast pulse --pressure \"1 kPa\" --duration \"1 ms\" --impulse \"1 kPa ms\"",
                   "moraine blast pulse: --impulse: \"1 kPa ms\" fits no decay: it must be above "
                   "zero and at most half of peak times duration\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 3 --plot a.pdf",
                   "moraine blast air: --plot: \"a.pdf\" must end in .svg or .png\n"},
       }) {
    CommandResult const result = call(line);
    EXPECT_EQ(result.code, 2) << line;
    EXPECT_EQ(result.err, message) << line;
    EXPECT_EQ(result.out, "") << line;
  }
}

TEST_F(BlastCommand, ReplacesNoFileUnasked) {
  std::string const line = "blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 3";
  write(path("a.csv"), "mine");
  write(path("a.png"), "mine");
  CommandResult const result = call(line + " --csv a.csv --plot a.png");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine blast air: --csv: \"a.csv\" exists and is not overwritten; name another file "
            "or add --force\n"
            "moraine blast air: --plot: \"a.png\" exists and is not overwritten; name another file "
            "or add --force\n");
  EXPECT_EQ(bytes_of(path("a.csv")), "mine");
  EXPECT_EQ(bytes_of(path("a.png")), "mine");
  EXPECT_EQ(call(line + " --csv a.csv --plot a.png --force").code, 0);
  EXPECT_EQ(read_table_csv(path("a.csv")).rows(), 3u);
  CommandResult const same = call(line + " --csv b.svg --plot b.svg");
  EXPECT_EQ(same.code, 2);
  EXPECT_NE(same.err.find("is the file of --csv too"), std::string::npos) << same.err;
}

// Nothing that was written is passed over in silence.
TEST_F(BlastCommand, RefusesWhatHasNoSay) {
  EXPECT_EQ(call("blast pulse --charge \"1 kg\" --distance \"5 m\" --duration \"9 ms\"").err,
            "moraine blast pulse: --duration: \"9 ms\" and --charge exclude each other; give "
            "--pressure with it\n");
  EXPECT_EQ(call("blast reflection --pressure \"1 bar\" --charge \"1 kg\" --explosive comp_b "
                 "--surface-burst")
                .err,
            "moraine blast reflection: --charge: \"1 kg\" and --pressure exclude each other\n"
            "moraine blast reflection: --explosive: \"comp_b\" and --pressure exclude each other\n"
            "moraine blast reflection: --surface-burst: and --pressure exclude each other\n");
  EXPECT_EQ(call("blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\"").err,
            "moraine blast air: --distances: \"1 m\" is not all: first value, last value and "
            "number of values are expected\n");
}

TEST_F(BlastCommand, SaysWhenItCannotWrite) {
  write(path("file"), "");
  CommandResult const result =
      call("blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 3 --csv file/a.csv");
  EXPECT_EQ(result.code, 4) << result.err;
}

}  // namespace
}  // namespace moraine
