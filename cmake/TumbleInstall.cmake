# cmake --install: the headers of every floor, of the exact solutions and, where nlohmann-json is, of the reader of scene files,
# and what find_package(Tumble) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(floors GLOBAL PROPERTY TUMBLE_FLOORS)
get_property(header_folders GLOBAL PROPERTY TUMBLE_HEADER_FOLDERS)
list(TRANSFORM floors PREPEND tumble_ OUTPUT_VARIABLE floor_targets)

install(DIRECTORY ${header_folders} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
if(TARGET tumble_exact)  # a course of a few chapters has none
  list(APPEND floor_targets tumble_exact)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/exact/tumble DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
endif()
if(TARGET tumble_scene)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/scene_reader/tumble DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
  install(TARGETS tumble_scene EXPORT TumbleSceneTargets)
  install(EXPORT TumbleSceneTargets NAMESPACE tumble:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble)
endif()
install(TARGETS ${floor_targets} tumble_tumble EXPORT TumbleTargets)
install(EXPORT TumbleTargets NAMESPACE tumble:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/TumbleConfig.cmake.in ${PROJECT_BINARY_DIR}/TumbleConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TumbleConfigVersion.cmake COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/TumbleConfig.cmake ${PROJECT_BINARY_DIR}/TumbleConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble)
