# pongsim_sources(SOURCES TESTS)
# The C++ files below the current folder: sources, and their tests, which are beside them and end in _test.cc.
function(pongsim_sources sources tests)
  file(GLOB_RECURSE all RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.cc)
  set(found ${all})
  list(FILTER found INCLUDE REGEX "_test\\.cc$")
  list(FILTER all EXCLUDE REGEX "_test\\.cc$")
  set(${sources} ${all} PARENT_SCOPE)
  set(${tests} ${found} PARENT_SCOPE)
endfunction()

# pongsim_layer(NAME [SOURCES ...] [USES third-party targets ...])
# A folder under src/ or components/shared/, as object files for the library and for the layer's tests. Without SOURCES all of
# the folder's.
function(pongsim_layer name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  if(NOT arg_SOURCES)
    pongsim_sources(arg_SOURCES tests)
  endif()
  add_library(pongsim_${name} OBJECT ${arg_SOURCES})
  target_precompile_headers(pongsim_${name} REUSE_FROM pongsim_precompiled)
  target_include_directories(pongsim_${name} PUBLIC ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/src
                                                    ${CMAKE_SOURCE_DIR}/components)
  target_link_libraries(pongsim_${name} PUBLIC Eigen3::Eigen PRIVATE pongsim_settings ${arg_USES})
  set_property(GLOBAL APPEND PROPERTY PONGSIM_LAYERS pongsim_${name})
  set_property(GLOBAL APPEND PROPERTY PONGSIM_LAYERS_USE ${arg_USES})
endfunction()

# pongsim_export(TARGET FILE)
# Exports only the symbols of a linker version script in cmake/, so that instantiations of other libraries' templates are
# not exported.
function(pongsim_export target file)
  set(map ${CMAKE_SOURCE_DIR}/cmake/${file})
  target_link_options(${target} PRIVATE LINKER:--version-script=${map})
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${map})
endfunction()

# pongsim_find_libraries(TARGET FOLDER [MORE])
# TARGET, which is installed into FOLDER, looks for pongsim's libraries where they are relative to itself; MORE: other folders
# to look in. The build tree has the layout of an installation, so these paths are the same from the start. CMake would end
# other ones with a colon to replace them later, and what follows a colon is the current folder.
function(pongsim_find_libraries target folder)
  file(RELATIVE_PATH toLibraries /prefix/${folder} /prefix/${CMAKE_INSTALL_LIBDIR})
  string(REGEX REPLACE "/$" "" origin "$ORIGIN/${toLibraries}")
  set(paths ${origin} ${ARGN})
  set_target_properties(${target} PROPERTIES BUILD_RPATH "${paths}" INSTALL_RPATH "${paths}")
  # Debian's packages have none: there the build tree's are removed on installation
  if(NOT CMAKE_SKIP_INSTALL_RPATH)
    set_target_properties(${target} PROPERTIES BUILD_WITH_INSTALL_RPATH ON)
  endif()
endfunction()

# pongsim_plugin(NAME SOURCES ... [USES third-party targets ...])
# A system's library; it sees only the installed API.
function(pongsim_plugin name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  set(target pongsim-${name}-system)
  add_library(${target} MODULE ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE pongsim pongsim_settings ${arg_USES})
  pongsim_export(${target} system.map)
  target_precompile_headers(${target} REUSE_FROM pongsim_precompiled)
  set_target_properties(${target} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PONGSIM_PLUGIN_SUBDIRECTORY})
  pongsim_find_libraries(${target} ${CMAKE_INSTALL_LIBDIR}/${PONGSIM_PLUGIN_SUBDIRECTORY})
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${PONGSIM_PLUGIN_SUBDIRECTORY})
  set_property(GLOBAL APPEND PROPERTY PONGSIM_PLUGINS ${target})
endfunction()

# pongsim_extension(NAME [PROGRAM target] [PAGE])
# Puts a component's descriptor, share/NAME.json (docs/extensions.md), where the program looks for it in the build tree and
# in an installation. PROGRAM, which `pongsim NAME` runs, adds its own actions and options to it. PAGE: also makes the manual
# page of the command, pongsim-NAME.
function(pongsim_extension name)
  cmake_parse_arguments(arg "PAGE" "PROGRAM" "" ${ARGN})
  set(written ${CMAKE_CURRENT_SOURCE_DIR}/share/${name}.json)
  set(descriptor ${CMAKE_BINARY_DIR}/share/pongsim/extensions/${name}.json)
  # leaks in what runs only here do not matter
  set(run ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0:new_delete_type_mismatch=0 ${CMAKE_CROSSCOMPILING_EMULATOR})
  if(arg_PROGRAM)
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/pongsim/extensions)
    set_property(TARGET ${arg_PROGRAM} APPEND PROPERTY LINK_DEPENDS ${written})
    add_custom_command(TARGET ${arg_PROGRAM} POST_BUILD VERBATIM BYPRODUCTS ${descriptor}
      COMMAND ${run} $<TARGET_FILE:${arg_PROGRAM}> --describe ${written} > ${descriptor})
    # without it, `pongsim run` would not have the options of the component's systems
    set_property(GLOBAL APPEND PROPERTY PONGSIM_PLUGINS ${arg_PROGRAM})
  else()
    configure_file(${written} ${descriptor} COPYONLY)
  endif()
  install(FILES ${descriptor} DESTINATION ${CMAKE_INSTALL_DATADIR}/pongsim/extensions)
  if(NOT arg_PAGE)
    return()
  endif()
  set(page ${CMAKE_CURRENT_BINARY_DIR}/pongsim-${name}.1)
  add_custom_command(OUTPUT ${page} DEPENDS pongsim pongsim_manual ${arg_PROGRAM} ${descriptor} VERBATIM
    COMMAND ${run} $<TARGET_FILE:pongsim_manual> ${CMAKE_CURRENT_BINARY_DIR} ${descriptor})
  add_custom_target(pongsim_${name}_words ALL DEPENDS ${page})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endfunction()

# pongsim_test(NAME [SOURCES ... | EXCEPT ...] [LINKS ...] [USES third-party targets ...] [TIMEOUT seconds])
# A GoogleTest program; each of its tests is a ctest test. Without SOURCES it has all tests of the folder, but those of
# EXCEPT. Links the layers, including hidden parts, unless LINKS names the library itself (`pongsim`), for a test that sees
# only the installed API. Nothing where no tests are built.
function(pongsim_test name)
  if(NOT BUILD_TESTING)
    return()
  endif()
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;EXCEPT;LINKS;USES" ${ARGN})
  if(NOT arg_SOURCES)
    pongsim_sources(sources arg_SOURCES)
    list(REMOVE_ITEM arg_SOURCES ${arg_EXCEPT})
  endif()
  if(NOT arg_LINKS)
    set(arg_LINKS pongsim_layers)
  endif()
  if(NOT arg_TIMEOUT)
    # for tests that hang; waits of a minute each on a busy machine are no hang
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test
                                           POSITION_INDEPENDENT_CODE OFF)
  target_link_libraries(${name} PRIVATE ${arg_LINKS} pongsim_test_support pongsim_test_settings
                                        GTest::gtest_main ${arg_USES})
  target_precompile_headers(${name} REUSE_FROM pongsim_test_precompiled)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300
                       PROPERTIES TIMEOUT ${arg_TIMEOUT} ENVIRONMENT "XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test/cache"
                       ENVIRONMENT_MODIFICATION "PONGSIM_OFFLINE=set:1")
endfunction()

# pongsim_test_program(TARGET)
# A program that tests run: compiled as they are, with their precompiled header.
function(pongsim_test_program target)
  target_link_libraries(${target} PRIVATE pongsim_test_settings)
  # what the precompiled header was made with
  target_compile_definitions(${target} PRIVATE GTEST_HAS_PTHREAD=1)
  target_precompile_headers(${target} REUSE_FROM pongsim_test_precompiled)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test
                                             POSITION_INDEPENDENT_CODE OFF)
endfunction()

# pongsim_test_library(NAME SOURCE FOLDER [USES third-party targets ...])
# A system that tests load from FOLDER of their build folder; knows only the installed API.
function(pongsim_test_library name source folder)
  cmake_parse_arguments(arg "" "" "USES" ${ARGN})
  add_library(${name} MODULE ${source})
  target_link_libraries(${name} PRIVATE pongsim pongsim_settings ${arg_USES})
  target_precompile_headers(${name} REUSE_FROM pongsim_precompiled)
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test/${folder})
endfunction()

# pongsim_plugin_test(NAME SOURCES ... [USES third-party targets ...])
# Tests of a system, which see only the installed API. All go into one program, systems_test, which builds faster.
function(pongsim_plugin_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set_property(GLOBAL APPEND PROPERTY PONGSIM_PLUGIN_TESTS ${arg_SOURCES})
  set_property(GLOBAL APPEND PROPERTY PONGSIM_PLUGIN_TESTS_USE ${arg_USES})
endfunction()

# pongsim_allocation_test(NAME SOURCE [USES third-party targets ...])
# A test that counts allocations or lets them fail: a program of its own, because it replaces operator new.
function(pongsim_allocation_test name source)
  if(NOT BUILD_TESTING)
    return()
  endif()
  pongsim_test(${name} SOURCES ${source} ${ARGN})
  # GCC warns because the replacement uses malloc
  target_compile_options(${name} PRIVATE -Wno-mismatched-new-delete)
endfunction()
