# The most expensive headers are precompiled once each for the library, the systems and the tests, which halves a build.
# Still include what you use: the preset `debug` builds without precompiled headers, so a missing #include shows there.
# A precompiled header is not free: GCC instantiates what its inline functions use in every file again (protobuf 0.06 s,
# gtest 0.2 s, json.hpp 0.5 s, CLI11 1.7 s). So it has only what nearly every file that uses it includes.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cc CONTENT "")
set(headers <algorithm> <chrono> <filesystem> <functional> <map> <memory> <optional> <string> <string_view>
            <unordered_map> <variant> <vector> <Eigen/Geometry>)

# pongsim_precompile(NAME [LEVEL -O... ...] USES targets ... [HEADERS headers ...])
# A precompiled header of its own, with HEADERS besides those that all share. GCC takes the optimization level from the
# precompiled header, not from the command line, so each LEVEL needs one.
function(pongsim_precompile name)
  cmake_parse_arguments(arg "" "" "LEVEL;USES;HEADERS" ${ARGN})
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
  if(arg_LEVEL)
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:${arg_LEVEL}>")
  endif()
  target_link_libraries(${name} PRIVATE ${arg_USES} Eigen3::Eigen)
  target_precompile_headers(${name} PRIVATE ${headers} ${arg_HEADERS})
endfunction()

pongsim_precompile(pongsim_precompiled USES pongsim_settings)
# for the layers that compute
pongsim_precompile(pongsim_computing_precompiled LEVEL -O3 USES pongsim_settings)
# for code that parses the options of a command: see pongsim_parses_options
pongsim_precompile(pongsim_options_precompiled LEVEL ${pongsim_quick_to_compile} USES pongsim_settings CLI11::CLI11
                   nlohmann_json::nlohmann_json HEADERS <CLI/App.hpp> <nlohmann/json.hpp>)
# what nearly every system uses; one message header brings those that all of them share
pongsim_precompile(pongsim_plugin_precompiled USES pongsim_settings PkgConfig::ignition_msgs
                   HEADERS <ignition/msgs/header.pb.h> <pongsim/system.hh>)
target_include_directories(pongsim_plugin_precompiled PRIVATE ${CMAKE_SOURCE_DIR}/include)
# GCC recognizes a header with `#pragma once` by its modification time, too. A precompiled header that ccache made in
# another clone has other times for our headers, so they would be read twice.
set_target_properties(pongsim_plugin_precompiled PROPERTIES CXX_COMPILER_LAUNCHER "")

if(BUILD_TESTING)
  # A test usually runs once per build: optimizing it costs more than it saves.
  add_library(pongsim_test_settings INTERFACE)
  target_compile_options(pongsim_test_settings INTERFACE "$<$<CONFIG:Release>:${pongsim_quick_to_compile}>")
  target_link_libraries(pongsim_test_settings INTERFACE pongsim_settings)
  if(PONGSIM_UNITY_BUILD)
    # A unity build includes the test's file, so GCC takes it for a header and warns about fixtures in anonymous
    # namespaces.
    target_compile_options(pongsim_test_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()

  pongsim_precompile(pongsim_test_precompiled USES pongsim_test_settings GTest::gtest PkgConfig::ignition_msgs
                     HEADERS <gtest/gtest.h> <ignition/msgs/header.pb.h>)
  # As by default in GCC: an OBJECT library's -fPIC does not match an executable's -fPIE.
  set_target_properties(pongsim_test_precompiled PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endif()
