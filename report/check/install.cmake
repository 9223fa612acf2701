# Installs the libraries that a program of its own needs to check projects: find_package(luxgate), target
# luxgate::check; see examples/embed. Headers keep their places below include/luxgate.
include(CMakePackageConfigHelpers)

set(libraries calc_model calc_radiosity rules gpu report report_check)
set_target_properties(report_check PROPERTIES EXPORT_NAME check)
install(TARGETS ${libraries} EXPORT luxgateTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/luxgate COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/calc ${PROJECT_SOURCE_DIR}/rules ${PROJECT_SOURCE_DIR}/gpu
                  ${PROJECT_SOURCE_DIR}/report
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/luxgate COMPONENT development
        FILES_MATCHING PATTERN "*.h" PATTERN "*.def" PATTERN "*.glsl"
        PATTERN "tools" EXCLUDE PATTERN "git" EXCLUDE PATTERN "shell" EXCLUDE PATTERN "cli" EXCLUDE PATTERN "python" EXCLUDE PATTERN "shaders" EXCLUDE PATTERN "packs" EXCLUDE)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/luxgate)
install(EXPORT luxgateTargets NAMESPACE luxgate:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/luxgateConfig.cmake.in
  ${PROJECT_BINARY_DIR}/luxgateConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/luxgateConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/luxgateConfig.cmake ${PROJECT_BINARY_DIR}/luxgateConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)
