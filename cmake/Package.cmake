# The package that find_package(pongsim) finds once pongsim is installed.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/pongsim)
set(PONGSIM_PLUGIN_FOLDER ${CMAKE_INSTALL_LIBDIR}/${PONGSIM_PLUGIN_SUBDIRECTORY})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pongsimConfig.cmake.in ${CMAKE_BINARY_DIR}/pongsimConfig.cmake
                              INSTALL_DESTINATION ${package})
# before 1.0 every minor version may break compatibility
write_basic_package_version_file(${CMAKE_BINARY_DIR}/pongsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/pongsimConfig.cmake ${CMAKE_BINARY_DIR}/pongsimConfigVersion.cmake
        DESTINATION ${package})
# What the packages are made of and with, where there is Python.
if(Python_Interpreter_FOUND)
  set(bill ${CMAKE_BINARY_DIR}/share/doc/pongsim/sbom.cdx.json)
  set(lock ${CMAKE_SOURCE_DIR}/components/web/page/package-lock.json)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/doc/pongsim)
  add_custom_command(OUTPUT ${bill} VERBATIM COMMAND ${Python_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/sbom ${bill}
    DEPENDS ${CMAKE_SOURCE_DIR}/tools/sbom ${CMAKE_SOURCE_DIR}/debian/control ${CMAKE_SOURCE_DIR}/docs/dependencies.md ${lock})
  add_custom_target(pongsim_bill_of_materials ALL DEPENDS ${bill})
  install(FILES ${bill} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
install(EXPORT pongsim NAMESPACE pongsim:: FILE pongsimTargets.cmake DESTINATION ${package})
