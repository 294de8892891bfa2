# The most expensive headers are precompiled once each for the library, the systems and the tests, which halves a build.
# Still include what you use: the preset `debug` builds without precompiled headers, so a missing #include shows there.
# A precompiled header is not free: GCC instantiates what its inline functions use in every file again (protobuf 0.06 s,
# gtest 0.2 s, json.hpp 0.5 s, CLI11 1.7 s). So it has only what nearly every file that uses it includes.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cc CONTENT "")
set(headers <algorithm> <chrono> <filesystem> <functional> <map> <memory> <optional> <string> <string_view>
            <unordered_map> <variant> <vector> <Eigen/Geometry>)

add_library(pongsim_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_link_libraries(pongsim_precompiled PRIVATE pongsim_settings Eigen3::Eigen)
target_precompile_headers(pongsim_precompiled PRIVATE ${headers})

# For the layers that compute: GCC takes the optimization level from the precompiled header, not from the command line.
add_library(pongsim_computing_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_compile_options(pongsim_computing_precompiled PRIVATE $<$<CONFIG:Release>:-O3>)
target_link_libraries(pongsim_computing_precompiled PRIVATE pongsim_settings Eigen3::Eigen)
target_precompile_headers(pongsim_computing_precompiled PRIVATE ${headers})

# For code that parses command lines: see pongsim_runs_once.
add_library(pongsim_once_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_compile_options(pongsim_once_precompiled PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(pongsim_once_precompiled PRIVATE pongsim_settings Eigen3::Eigen CLI11::CLI11
                                                       nlohmann_json::nlohmann_json)
target_precompile_headers(pongsim_once_precompiled PRIVATE ${headers} <CLI/App.hpp> <nlohmann/json.hpp>)

# Also what nearly every system uses; one message header brings those that all of them share.
add_library(pongsim_plugin_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_include_directories(pongsim_plugin_precompiled PRIVATE ${CMAKE_SOURCE_DIR}/include)
target_link_libraries(pongsim_plugin_precompiled PRIVATE pongsim_settings Eigen3::Eigen PkgConfig::ignition_msgs)
target_precompile_headers(pongsim_plugin_precompiled PRIVATE ${headers} <ignition/msgs/header.pb.h> <pongsim/system.hh>)
# GCC recognizes a header with `#pragma once` by its modification time, too. A precompiled header that ccache made in
# another clone has other times for our headers, so they would be read twice.
set_target_properties(pongsim_plugin_precompiled PROPERTIES CXX_COMPILER_LAUNCHER "")

if(BUILD_TESTING)
  # A test usually runs once per build: optimizing it costs more than it saves. Inlining small functions, as -Og does, costs
  # less than generating code for each.
  add_library(pongsim_test_settings INTERFACE)
  target_compile_options(pongsim_test_settings INTERFACE $<$<CONFIG:Release>:-Og>)
  target_link_libraries(pongsim_test_settings INTERFACE pongsim_settings)
  if(PONGSIM_UNITY_BUILD)
    # A unity build includes the test's file, so GCC takes it for a header and warns about fixtures in anonymous
    # namespaces.
    target_compile_options(pongsim_test_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()

  add_library(pongsim_test_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
  target_link_libraries(pongsim_test_precompiled PRIVATE pongsim_test_settings Eigen3::Eigen GTest::gtest
                                                         PkgConfig::ignition_msgs)
  target_precompile_headers(pongsim_test_precompiled PRIVATE ${headers} <gtest/gtest.h> <ignition/msgs/header.pb.h>)
  # As by default in GCC: an OBJECT library's -fPIC does not match an executable's -fPIE.
  set_target_properties(pongsim_test_precompiled PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endif()
