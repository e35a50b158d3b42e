# What `cmake --install` puts where: the program, the libraries, their headers, which are those of include/gnomon, and the
# package that find_package(gnomon CONFIG) reads. The viz library has a file of its own there, because it alone needs VTK.
# With GNOMON_PROOF gnomon-proof is installed too, with GNOMON_PYTHON the Python package (apps/python): components of their own.
include(CMakePackageConfigHelpers)

set(gnomon_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gnomon)

install(TARGETS gnomon)
install(FILES ${PROJECT_BINARY_DIR}/man/gnomon.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
if(GNOMON_PROOF)
  install(TARGETS gnomon-proof COMPONENT proof)
  install(FILES ${PROJECT_BINARY_DIR}/man/gnomon-proof.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT proof)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES cmake/gnomon.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME gnomon)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon FILES_MATCHING PATTERN "*.schema.json")
install(FILES viz/vtk/gnomon_reader.py DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon/paraview)
# Pages link to each other and to the examples as they lie in the sources.
set(gnomon_example_files FILES_MATCHING PATTERN "*.scene.json" PATTERN "*.goals.json" PATTERN "*.paint.json" PATTERN "*.csv" PATTERN "*.stl" PATTERN "*.obj" PATTERN "*.mtl" PATTERN "*.license")
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon/examples ${gnomon_example_files})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} ${gnomon_example_files} PATTERN "*.cpp")
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES geometry/references.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/geometry)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.py")
# `gnomon example` finds them beside the program, in a build too.
file(COPY examples/ DESTINATION ${PROJECT_BINARY_DIR}/share/gnomon/examples ${gnomon_example_files})
install(TARGETS gnomon_geometry gnomon_scene gnomon_shading gnomon_inverse EXPORT gnomonTargets)
install(TARGETS gnomon_viz EXPORT gnomonVizTargets)
install(DIRECTORY include/gnomon DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
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
