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
install(EXPORT pongsim NAMESPACE pongsim:: FILE pongsimTargets.cmake DESTINATION ${package})
