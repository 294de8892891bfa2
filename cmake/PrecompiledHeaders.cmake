# The headers that cost most to read are read once for the library, for the systems and for the tests: half of a build.
# Include what you use all the same: the preset `debug` builds without them, and a missing #include shows there.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cc CONTENT "")
set(headers <algorithm> <chrono> <filesystem> <functional> <map> <memory> <optional> <string> <string_view>
            <unordered_map> <variant> <vector> <Eigen/Geometry>)

add_library(pongsim_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_link_libraries(pongsim_precompiled PRIVATE pongsim_settings Eigen3::Eigen)
target_precompile_headers(pongsim_precompiled PRIVATE ${headers})

# For the layers that compute: GCC takes the level of optimization from the header, whatever the command line says.
add_library(pongsim_computing_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_compile_options(pongsim_computing_precompiled PRIVATE $<$<CONFIG:Release>:-O3>)
target_link_libraries(pongsim_computing_precompiled PRIVATE pongsim_settings Eigen3::Eigen)
target_precompile_headers(pongsim_computing_precompiled PRIVATE ${headers})

# With what nearly every system uses; the first message stands for the headers that all share.
add_library(pongsim_plugin_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_include_directories(pongsim_plugin_precompiled PRIVATE ${CMAKE_SOURCE_DIR}/include)
target_link_libraries(pongsim_plugin_precompiled PRIVATE pongsim_settings Eigen3::Eigen PkgConfig::ignition_msgs)
target_precompile_headers(pongsim_plugin_precompiled PRIVATE ${headers} <ignition/msgs/header.pb.h> <pongsim/system.hh>)
# GCC knows a header of `#pragma once` again by its time of change, too: one from ccache that was made in another clone has
# other times for ours, and they are read twice.
set_target_properties(pongsim_plugin_precompiled PROPERTIES CXX_COMPILER_LAUNCHER "")

if(BUILD_TESTING)
  # A test is run once where it is compiled: optimizing it costs more than it gives (a sixth of a build).
  add_library(pongsim_test_settings INTERFACE)
  target_compile_options(pongsim_test_settings INTERFACE $<$<CONFIG:Release>:-O0>)
  target_link_libraries(pongsim_test_settings INTERFACE pongsim_settings)
  if(PONGSIM_UNITY_BUILD)
    # GCC takes the file of a fixture in an anonymous namespace for a header, since it is included.
    target_compile_options(pongsim_test_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()

  add_library(pongsim_test_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
  target_link_libraries(pongsim_test_precompiled PRIVATE pongsim_test_settings Eigen3::Eigen GTest::gtest)
  target_precompile_headers(pongsim_test_precompiled PRIVATE ${headers} <gtest/gtest.h>)
  # As GCC does by default: an OBJECT library's -fPIC would not fit an executable's -fPIE.
  set_target_properties(pongsim_test_precompiled PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endif()
