# The installed package: find_package(repousse) -> repousse::datapath, repousse::config,
# repousse::tlm. The component `device` is these; the program is beside it.
include_guard(GLOBAL)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(installed GLOBAL PROPERTY REPOUSSE_INSTALLED)
install(TARGETS ${installed} EXPORT repousseTargets ARCHIVE COMPONENT device)
install(DIRECTORY datapath tlm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/repousse COMPONENT device
        FILES_MATCHING PATTERN *.h)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/repousse)
install(EXPORT repousseTargets NAMESPACE repousse:: DESTINATION ${package_dir}
        COMPONENT device)
configure_package_config_file(cmake/repousseConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/repousseConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/repousseConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/repousseConfig.cmake
              ${PROJECT_BINARY_DIR}/repousseConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT device)
