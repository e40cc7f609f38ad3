// A case whose keys can be replaced.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "setup/case.hpp"
#include "sweep/case_key.hpp"

namespace moraine {

/// A key and its new value, as TOML.
struct Replacement {
  CaseKey key;
  std::string value;
};

/// A case file from which members of a sweep are made.
class CaseTemplate {
 public:
  /// Reads and checks the case. Throws InputErrors.
  explicit CaseTemplate(std::filesystem::path file);

  Case const& base() const { return base_; }
  std::filesystem::path const& file() const { return file_; }

  /// The case with these keys replaced, checked. Throws InputErrors, whose places are none of the
  /// case file.
  Case with(std::span<Replacement const> replacements) const;

  /// The same as a case file that lies in `folder`: names of files count from there. Comments at
  /// the top hold the digests of these files, so that the digest of the text tells whether two
  /// cases are the same. Throws std::runtime_error if such a file cannot be read.
  std::string text(std::span<Replacement const> replacements,
                   std::filesystem::path const& folder) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  Case base_;
};

}  // namespace moraine
