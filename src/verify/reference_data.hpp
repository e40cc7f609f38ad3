// Measurements of others, which stand beside the project and are no part of it.
#pragma once

#include <filesystem>
#include <string>

namespace moraine {

/// A file of the reference data: in the folder that the environment variable MORAINE_REFERENCE_DATA
/// names, else in shared/data beside the folder `beside`. Empty where it is not there.
std::filesystem::path reference_file(std::string const& name, std::filesystem::path const& beside);

/// The same for a program that runs in the folder of the sources.
std::filesystem::path reference_file(std::string const& name);

inline constexpr char const* no_reference_data =
    "the reference data are not here; MORAINE_REFERENCE_DATA may name their folder";

}  // namespace moraine
