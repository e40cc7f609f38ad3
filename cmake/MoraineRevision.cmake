# moraine_add_git_revision(sources...): defines MORAINE_GIT_REVISION, the commit as of the last
# configure ("-dirty" when files differed from it, "unknown" without git).
#
# The value changes with every commit. Only the sources that name it get the definition, so that a
# commit recompiles those alone and not everything.
find_package(Git QUIET)

function(moraine_git output)
  set(text "")
  if(GIT_FOUND)
    execute_process(COMMAND "${GIT_EXECUTABLE}" ${ARGN}
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
      OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

function(moraine_add_git_revision)
  moraine_git(revision describe --always --dirty --abbrev=12 --exclude=*)
  if(NOT revision)
    set(revision "unknown")
  endif()
  foreach(source IN LISTS ARGN)
    file(STRINGS "${source}" uses REGEX "MORAINE_GIT_REVISION" LIMIT_COUNT 1)
    if(uses)
      set_property(SOURCE "${source}" APPEND PROPERTY
        COMPILE_DEFINITIONS "MORAINE_GIT_REVISION=\"${revision}\"")
    endif()
  endforeach()

  # Git appends to this file at every commit and checkout: configure again when it changes.
  moraine_git(head_log rev-parse --git-path logs/HEAD)
  cmake_path(ABSOLUTE_PATH head_log BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  if(EXISTS "${head_log}" AND NOT IS_DIRECTORY "${head_log}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${head_log}")
  endif()
endfunction()
