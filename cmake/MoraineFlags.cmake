# moraine_flags: how our own sources are compiled. MORAINE_COMPILER_FLAGS: the same, as text for the
# records that a run writes.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

# Never -ffast-math: it assumes that there is no NaN and removes the checks that stop a broken run.
# These allow what is wanted of it. Contraction must be asked for, because -std=c++20 (without
# GNU extensions) turns it off.
set(moraine_options -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffp-contract=fast)

if(MORAINE_NATIVE)
  check_cxx_compiler_flag(-march=native MORAINE_HAS_MARCH_NATIVE)
  if(MORAINE_HAS_MARCH_NATIVE)
    list(APPEND moraine_options -march=native)
    set(CMAKE_REQUIRED_FLAGS "-march=native")
    check_cxx_source_compiles("
      #ifndef __AVX512F__
      #error no 512-bit registers
      #endif
      int main() { return 0; }" MORAINE_HAS_AVX512)
    unset(CMAKE_REQUIRED_FLAGS)
    check_cxx_compiler_flag(-mprefer-vector-width=512 MORAINE_HAS_PREFER_512)
    if(MORAINE_HAS_AVX512 AND MORAINE_HAS_PREFER_512)
      list(APPEND moraine_options -mprefer-vector-width=512)
    endif()
  endif()
elseif(MORAINE_ARCH)
  list(APPEND moraine_options "-march=${MORAINE_ARCH}")
endif()

set(moraine_sanitizers "")
if(MORAINE_FUZZ)
  # Conversions of numbers that do not fit are no part of "undefined" and are what input provokes.
  set(moraine_sanitizers -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow)
elseif(MORAINE_SANITIZE STREQUAL "address")
  set(moraine_sanitizers -fsanitize=address,undefined)
elseif(MORAINE_SANITIZE STREQUAL "thread")
  set(moraine_sanitizers -fsanitize=thread)
elseif(MORAINE_SANITIZE)
  message(FATAL_ERROR "MORAINE_SANITIZE is ${MORAINE_SANITIZE}: address, thread or nothing")
endif()
set(moraine_link_options ${moraine_sanitizers})
if(moraine_sanitizers)
  list(APPEND moraine_options ${moraine_sanitizers} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
endif()

set(moraine_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wnon-virtual-dtor -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12 inside its own headers: string concatenation (GCC bug 105651), AVX-512
  # intrinsics (105593).
  list(APPEND moraine_warnings -Wno-restrict -Wno-maybe-uninitialized -Wno-uninitialized)
else()
  # Clang counts conversions of signs, which GCC does not in C++.
  list(APPEND moraine_warnings -Wno-sign-conversion)
endif()
if(MORAINE_WERROR)
  list(APPEND moraine_warnings -Werror)
endif()

add_library(moraine_flags INTERFACE)
target_compile_options(moraine_flags INTERFACE ${moraine_options} ${moraine_warnings})
target_link_options(moraine_flags INTERFACE ${moraine_link_options})

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(JOIN " " MORAINE_COMPILER_FLAGS
  -std=c++20 ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${moraine_options})
message(STATUS "Moraine: ${CMAKE_BUILD_TYPE} build, ${MORAINE_COMPILER_FLAGS}")
