// A folder of its own for each test, removed at the end.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace moraine {

class ScratchFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    auto const* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("moraine_") + info->test_suite_name() + "_" + info->name() +
                       "_" + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '_');  // of tests with parameters
    folder_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(std::string const& name) const { return folder_ / name; }

  static std::string bytes_of(std::filesystem::path const& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void write(std::filesystem::path const& file, std::string const& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path folder_;
};

/// The message of the exception of type E that `action` throws; empty if it throws none.
template <class E, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (E const& error) {
    return error.what();
  }
  return "";
}

}  // namespace moraine
