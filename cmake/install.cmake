# What `cmake --install` puts where: the program, the libraries, their headers below include/gnomon, and the package
# that find_package(gnomon CONFIG) reads. The viz library has a file of its own there, because it alone needs VTK.
include(CMakePackageConfigHelpers)

set(gnomon_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gnomon)

install(TARGETS gnomon)
install(TARGETS gnomon_geometry gnomon_scene EXPORT gnomonTargets)
install(TARGETS gnomon_viz EXPORT gnomonVizTargets)
install(DIRECTORY geometry viz DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gnomon FILES_MATCHING PATTERN "*.h")
install(EXPORT gnomonTargets NAMESPACE gnomon:: DESTINATION ${gnomon_package_dir})
install(EXPORT gnomonVizTargets NAMESPACE gnomon:: DESTINATION ${gnomon_package_dir})

# The package asks for the VTK components that the viz library links.
get_target_property(gnomon_vtk_components gnomon_viz LINK_LIBRARIES)
list(FILTER gnomon_vtk_components INCLUDE REGEX "^VTK::")
list(TRANSFORM gnomon_vtk_components REPLACE "^VTK::" "")
list(JOIN gnomon_vtk_components " " gnomon_vtk_components)

configure_package_config_file(cmake/gnomonConfig.cmake.in ${PROJECT_BINARY_DIR}/gnomonConfig.cmake
  INSTALL_DESTINATION ${gnomon_package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gnomonConfig.cmake ${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake
  DESTINATION ${gnomon_package_dir})
