# What `cmake --install` puts where: the program, the libraries, their public headers below include/gnomon, and the package
# that find_package(gnomon CONFIG) reads. The viz library has a file of its own there, because it alone needs VTK.
# A header is public if all it includes is public too, or the standard library's.
# With GNOMON_PROOF gnomon-proof is installed too, as a component of its own.
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
install(FILES viz/gnomon_reader.py DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon/paraview)
# Pages link to each other and to the examples as they lie in the sources.
set(gnomon_example_files FILES_MATCHING PATTERN "*.scene.json" PATTERN "*.csv" PATTERN "*.stl" PATTERN "*.license")
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon/examples ${gnomon_example_files})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.cpp" PATTERN "*.license")
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES geometry/references.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/geometry)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.py")
# `gnomon example` finds them beside the program, in a build too.
file(COPY examples/ DESTINATION ${PROJECT_BINARY_DIR}/share/gnomon/examples ${gnomon_example_files})
install(TARGETS gnomon_geometry gnomon_scene gnomon_shading EXPORT gnomonTargets)
install(TARGETS gnomon_viz EXPORT gnomonVizTargets)
foreach(header IN ITEMS
    geometry/contact.h
    geometry/discontinuity/discontinuity_surface.h
    geometry/discontinuity/event_name.h
    geometry/discontinuity/event_range.h
    geometry/discontinuity/receiver_mesh.h
    geometry/errors.h
    geometry/exact_number.h
    geometry/indices.h
    geometry/length_unit.h
    geometry/planar/extremal_lines.h
    geometry/planar/flatland.h
    geometry/planar/pair.h
    geometry/planar/partition.h
    geometry/planar/partition_in_box.h
    geometry/planar/partition_location.h
    geometry/planar/receiver_events.h
    geometry/planar/region_of.h
    geometry/planar/regions.h
    geometry/planar/regions_in_box.h
    geometry/planar/sight.h
    geometry/point.h
    geometry/printed_bound.h
    geometry/region.h
    geometry/scene/convex_parts.h
    geometry/scene/scene.h
    geometry/scene/scene_reader.h
    geometry/spatial/closed_surface.h
    geometry/spatial/convex_blocker.h
    geometry/spatial/convex_polygon.h
    geometry/spatial/convex_solid.h
    geometry/spatial/extremal_planes.h
    geometry/spatial/light.h
    geometry/spatial/merged_occlusion.h
    geometry/spatial/plane_coefficients.h
    geometry/spatial/position.h
    geometry/spatial/shadow_volume.h
    geometry/spatial/volume_mesh.h
    geometry/visibility/blocker_set.h
    geometry/visibility/fast_linear_visibility.h
    geometry/visibility/fast_point_visibility.h
    geometry/visibility/fast_visibility.h
    geometry/visibility/light_visibility.h
    geometry/visibility/receiver_front.h
    geometry/visibility/visibility.h
    shading/irradiance.h
    shading/irradiance_summary.h
    shading/lambert.h
    shading/light_irradiance.h
    shading/planar_irradiance.h
    shading/receiver_grid.h
    shading/unit_conversion.h
    viz/grid_file.h
    viz/picture.h
    viz/result_error.h
    viz/series_writer.h
    viz/receiver_result.h
    viz/shadow_result.h
    viz/shadow_writer.h)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gnomon/${folder})
endforeach()
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
