// Commands that help and documentation show.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace moraine {

/// The words of a command line behind "moraine", as a shell would split it at blanks and quotes.
inline std::vector<std::string> words_of_command(std::string const& line) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false, open = false;
  for (char const c : line) {
    if (c == '"') {
      quoted = !quoted;
      open = true;
    } else if (c == ' ' && !quoted) {
      if (open) words.push_back(word);
      word.clear();
      open = false;
    } else {
      word += c;
      open = true;
    }
  }
  if (open) words.push_back(word);
  if (!words.empty()) words.erase(words.begin());
  return words;
}

/// Lines of a text that are commands: "moraine ..." behind `prompt`.
inline std::vector<std::string> commands_in(std::string const& text, std::string const& prompt) {
  std::vector<std::string> commands;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(prompt + "moraine ")) commands.push_back(line.substr(prompt.size()));
  return commands;
}

/// A command with what it prints, in a page: a line "    $ moraine ...", then lines that are
/// indented as well, until one that is not or the next command.
struct ShownCommand {
  std::string command;
  std::string output;
};

inline std::vector<ShownCommand> shown_commands(std::string const& page) {
  std::vector<ShownCommand> shown;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    $ moraine ")) {
      shown.push_back({line.substr(6), ""});
      inside = true;
    } else if (inside && (line.empty() || line.starts_with("    "))) {
      shown.back().output += (line.empty() ? "" : line.substr(4)) + "\n";
    } else {
      inside = false;
    }
  }
  return shown;
}

}  // namespace moraine
