# moraine_embed_texts(output folder header function): writes a C++ source that defines `function`,
# declared in `header`, which returns every FOLDER/*.toml as an EmbeddedText, sorted by name.
# Configures again when one changes.
function(moraine_embed_texts output folder header function)
  file(GLOB text_files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.toml")
  list(SORT text_files)
  set(entries "")
  foreach(text_file IN LISTS text_files)
    cmake_path(GET text_file STEM name)
    file(READ "${text_file}" text)
    string(APPEND entries "    EmbeddedText{\"${name}\", R\"text(${text})text\"},\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${text_files})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/generated/${function}.cpp")
  file(WRITE "${source}.new" "#include <array>

#include \"${header}\"

namespace moraine {

std::span<EmbeddedText const> ${function}() {
  static constexpr std::array list{
${entries}  };
  return list;
}

}  // namespace moraine
")
  file(COPY_FILE "${source}.new" "${source}" ONLY_IF_DIFFERENT)
  set(${output} "${source}" PARENT_SCOPE)
endfunction()
