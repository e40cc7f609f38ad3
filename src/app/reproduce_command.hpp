// moraine reproduce: a published study, its cases run and set beside its numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace moraine {

struct ReproduceOptions {
  std::string study;   // empty: list them
  std::string output;  // default: out/STUDY
  std::string csv;     // file for the table; empty: none
  int threads = 0;     // 0: all
};

void add_reproduce_command(CLI::App& app, ReproduceOptions& options);
std::optional<int> run_reproduce_command(CLI::App const& app, ReproduceOptions const& options);

}  // namespace moraine
