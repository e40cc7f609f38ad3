# moraine_libraries: everything we use of others. On Debian, tools/install_packages.sh installs it.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(pugixml REQUIRED)
find_package(Boost 1.74 REQUIRED)  # headers: Math and Odeint, in src/exact
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)

pkg_check_modules(HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)  # of one source alone
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

# UDUNITS-2 ships no CMake package; CLI11 and the part of KISS FFT for doubles are only headers.
find_path(UDUNITS2_INCLUDE_DIR udunits2.h PATH_SUFFIXES udunits2 REQUIRED)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
find_path(KISSFFT_INCLUDE_DIR kissfft.hh PATH_SUFFIXES kissfft REQUIRED)

add_library(moraine_libraries INTERFACE)
target_include_directories(moraine_libraries SYSTEM INTERFACE
  "${UDUNITS2_INCLUDE_DIR}" "${CLI11_INCLUDE_DIR}" "${KISSFFT_INCLUDE_DIR}")
target_link_libraries(moraine_libraries INTERFACE
  OpenMP::OpenMP_CXX fmt::fmt tomlplusplus::tomlplusplus
  nlohmann_json::nlohmann_json Boost::headers pugixml::pugixml ZLIB::ZLIB
  PkgConfig::CAIRO PkgConfig::XXHASH PkgConfig::HDF5 PkgConfig::MUPARSER "${UDUNITS2_LIBRARY}")
