# cpack -G DEB makes a package of what `cmake --install` installs; gnomon-proof and the Python package, if they were built,
# are packages of their own.
# Shared libraries are found by dpkg-shlibdeps; what the
# program only uses when asked to (a virtual display, three.js) is recommended.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gnomon)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Exact shadow geometry: umbra, penumbra and visible light")
set(CPACK_PACKAGE_DESCRIPTION
"gnomon computes exact shadows: for a light and opaque blockers it says where the umbra, the penumbra and the light are,
and which edges and vertices make each boundary. The package holds the program with its manual page, the libraries with
their headers, and a plugin for ParaView.")
set(CPACK_PACKAGE_CONTACT "The gnomon maintainers <maintainers@users.noreply.github.com>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL gnomon)
set(CPACK_DEBIAN_GNOMON_PACKAGE_NAME gnomon)
if(GNOMON_PROOF)
  list(APPEND CPACK_COMPONENTS_ALL proof)
  set(CPACK_DEBIAN_PROOF_PACKAGE_NAME gnomon-proof)
  set(CPACK_DEBIAN_PROOF_PACKAGE_DEPENDS "gnomon (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PROOF_PACKAGE_RECOMMENDS "")
  set(CPACK_COMPONENT_PROOF_DESCRIPTION
"checks the numbered statements of the theory that gnomon rests on (gnomon theorems), and measures gnomon's speed against
error beside other programs (gnomon report).")
endif()
if(GNOMON_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gnomon)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "gnomon-proof, python3-vtk9")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"computes exact shadows from Python: numpy arrays in, numpy arrays out, the same answers as the program gnomon.")
endif()
set(CPACK_COMPONENT_GNOMON_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_GNOMON_PACKAGE_RECOMMENDS "xvfb, libgl1-mesa-dri, libjs-three")
set(CPACK_DEBIAN_GNOMON_PACKAGE_SUGGESTS "paraview, libcgal-dev, libvtk9-dev")
include(CPack)
