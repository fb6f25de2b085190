# find_package(verdigris CONFIG) from a foreign project.
include(CMakePackageConfigHelpers)
set(VERDIGRIS_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/verdigris)

set(VERDIGRIS_TARGETS verdigris_core verdigris_io)
if(VERDIGRIS_GL)
  list(APPEND VERDIGRIS_TARGETS verdigris_gl)
endif()
install(TARGETS ${VERDIGRIS_TARGETS} EXPORT verdigrisTargets)
install(DIRECTORY include/verdigris DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(EXPORT verdigrisTargets NAMESPACE verdigris:: DESTINATION ${VERDIGRIS_CONFIG_DIR})
configure_package_config_file(cmake/verdigrisConfig.cmake.in ${PROJECT_BINARY_DIR}/verdigrisConfig.cmake
  INSTALL_DESTINATION ${VERDIGRIS_CONFIG_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/verdigrisConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/verdigrisConfig.cmake ${PROJECT_BINARY_DIR}/verdigrisConfigVersion.cmake
  DESTINATION ${VERDIGRIS_CONFIG_DIR})
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Beside the models they name.
install(DIRECTORY presets DESTINATION ${CMAKE_INSTALL_DATADIR}/verdigris FILES_MATCHING PATTERN "*.toml")
