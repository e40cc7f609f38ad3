// Runs `moraine blast` and reads its answers.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {

/// Words of a command line, as a shell splits them.
inline std::vector<std::string> words_of(std::string const& line) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false, open = false;
  for (char const c : line + " ") {
    if (c == '"') {
      quoted = !quoted;
      open = true;
    } else if (c != ' ' || quoted) {
      word += c;
      open = true;
    } else if (open) {
      words.push_back(word);
      word.clear();
      open = false;
    }
  }
  return words;
}

class BlastCommand : public ScratchFolder {
 protected:
  /// Runs "blast ...", or "moraine blast ..." with its first word.
  CommandResult call(std::string const& line) {
    std::vector<std::string> words = words_of(line);
    if (!words.empty() && words.front() == "moraine") words.erase(words.begin());
    return moraine_command(path(""), words);
  }

  nlohmann::json json(std::string const& line) {
    CommandResult const result = call(line + " --json");
    EXPECT_EQ(result.code, 0) << line << "\n" << result.err;
    return nlohmann::json::parse(result.out);
  }

  /// Value of the first estimate of a measure by a relation.
  static double value(nlohmann::json const& answer, std::string const& measure,
                      std::string const& relation) {
    for (auto const& estimate : answer.at("estimates"))
      if (estimate.at("measure") == measure && estimate.at("relation") == relation)
        return estimate.at("value");
    ADD_FAILURE() << measure << " by " << relation << " is missing";
    return 0.0;
  }

  void expect_files(std::vector<std::string> const& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
      if (words[i] == "--csv" || words[i] == "--plot") {
        EXPECT_GT(std::filesystem::file_size(path(words[i + 1])), 500u) << words[i + 1];
      }
  }
};

}  // namespace moraine
