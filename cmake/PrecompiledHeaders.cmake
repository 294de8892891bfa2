# Two precompiled headers: one for what pongsim is made of, one for tests, which adds GoogleTest. Still include what you use:
# the preset `debug` builds without them, so a missing #include shows there. GCC compiles what includes a precompiled header
# with that header's optimization level, whatever -O the command line says.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cc CONTENT "")
set(headers <algorithm> <chrono> <filesystem> <functional> <map> <memory> <optional> <string> <string_view>
            <unordered_map> <variant> <vector> <Eigen/Geometry>)

add_library(pongsim_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
target_link_libraries(pongsim_precompiled PRIVATE pongsim_settings Eigen3::Eigen)
target_precompile_headers(pongsim_precompiled PRIVATE ${headers})

if(BUILD_TESTING)
  add_library(pongsim_test_settings INTERFACE)
  target_link_libraries(pongsim_test_settings INTERFACE pongsim_settings)
  # GCC 12 takes empty optionals in what a test makes for uninitialized
  target_compile_options(pongsim_test_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(PONGSIM_UNITY_BUILD)
    # A unity build includes the test's file, so GCC takes it for a header and warns about fixtures in anonymous
    # namespaces.
    target_compile_options(pongsim_test_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()

  add_library(pongsim_test_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cc)
  target_link_libraries(pongsim_test_precompiled PRIVATE pongsim_test_settings Eigen3::Eigen GTest::gtest)
  target_precompile_headers(pongsim_test_precompiled PRIVATE ${headers} <gtest/gtest.h>)
  # As by default in GCC: an OBJECT library's -fPIC does not match an executable's -fPIE.
  set_target_properties(pongsim_test_precompiled PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endif()
