# moraine_embed_cases(output): writes a C++ source that holds every cases/*/case.toml as text, so
# that the program verifies exactly the cases that it ships with. Configures again when one changes.
function(moraine_embed_cases output)
  file(GLOB case_files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/cases/*/case.toml")
  list(SORT case_files)
  set(entries "")
  foreach(case_file IN LISTS case_files)
    cmake_path(GET case_file PARENT_PATH folder)
    cmake_path(GET folder FILENAME name)
    file(READ "${case_file}" text)
    string(APPEND entries "    ShippedCase{\"${name}\", R\"case(${text})case\"},\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${case_files})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/generated/shipped_cases_list.cpp")
  file(WRITE "${source}.new" "#include <array>

#include \"verify/shipped_cases.hpp\"

namespace moraine {

std::span<ShippedCase const> shipped_cases() {
  static constexpr std::array list{
${entries}  };
  return list;
}

}  // namespace moraine
")
  file(COPY_FILE "${source}.new" "${source}" ONLY_IF_DIFFERENT)
  set(${output} "${source}" PARENT_SCOPE)
endfunction()
