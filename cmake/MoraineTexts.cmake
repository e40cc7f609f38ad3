# moraine_embed_texts(output pattern header function): writes a C++ source that defines `function`,
# declared in `header`, which returns every file that matches as an EmbeddedText, sorted by name.
# Configures again when one changes.
function(moraine_embed_texts output pattern header function)
  file(GLOB text_files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${pattern}")
  list(SORT text_files)
  set(entries "")
  foreach(text_file IN LISTS text_files)
    cmake_path(GET text_file STEM name)
    if(name STREQUAL "case")  # each in a folder of its name
      cmake_path(GET text_file PARENT_PATH text_folder)
      cmake_path(GET text_folder FILENAME name)
    endif()
    file(READ "${text_file}" text)
    string(APPEND entries "    EmbeddedText{\"${name}\", R\"text(${text})text\"sv},\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${text_files})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/generated/${function}.cpp")
  file(WRITE "${source}.new" "#include <array>

#include \"${header}\"

namespace moraine {

std::span<EmbeddedText const> ${function}() {
  using namespace std::string_view_literals;  // whose length is not counted
  static constexpr std::array list{
${entries}  };
  return list;
}

}  // namespace moraine
")
  file(COPY_FILE "${source}.new" "${source}" ONLY_IF_DIFFERENT)
  set(${output} "${source}" PARENT_SCOPE)
endfunction()
