// An archive in memory, whose contents a test may change between saving and restoring.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "base/archive.hpp"

namespace moraine {

class MemoryArchive : public Archive {
 public:
  bool restoring() const override { return restoring_; }
  void restore() { restoring_ = true; }

  /// A saved piece, to be changed.
  template <class T>
  T& piece(std::string const& name) {
    return std::get<T>(pieces_.at(name));
  }

  void number(std::string_view name, double& value) override { exchange(name, value); }
  void number(std::string_view name, std::uint64_t& value) override { exchange(name, value); }
  void text(std::string_view name, std::string& value) override { exchange(name, value); }
  void array(std::string_view name, std::string_view, std::vector<double>& values) override {
    exchange(name, values);
  }
  void array(std::string_view name, std::string_view, std::vector<std::uint64_t>& values) override {
    exchange(name, values);
  }
  void array(std::string_view name, std::string_view, std::vector<std::uint32_t>& values) override {
    exchange(name, values);
  }
  void array(std::string_view name, std::string_view, std::vector<std::int32_t>& values) override {
    exchange(name, values);
  }
  void array(std::string_view name, std::string_view, std::vector<std::uint8_t>& values) override {
    exchange(name, values);
  }

 private:
  template <class T>
  void exchange(std::string_view name, T& value) {
    if (restoring_)
      value = piece<T>(std::string(name));
    else
      pieces_[std::string(name)] = value;
  }

  std::map<std::string, std::variant<double, std::uint64_t, std::string, std::vector<double>,
                                     std::vector<std::uint64_t>, std::vector<std::uint32_t>,
                                     std::vector<std::int32_t>, std::vector<std::uint8_t>>>
      pieces_;
  bool restoring_ = false;
};

}  // namespace moraine
