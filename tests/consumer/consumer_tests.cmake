# Installs the build into a folder of the build tree; then an outside project finds it there, is built and run.
set(consumer_prefix ${CMAKE_CURRENT_BINARY_DIR}/consumer/prefix)

add_test(NAME Install.CopiesProgramLibrariesHeadersAndPackage
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${consumer_prefix})
set_tests_properties(Install.CopiesProgramLibrariesHeadersAndPackage PROPERTIES
  FIXTURES_SETUP installed_gnomon LABELS install)

add_test(NAME Install.AnOutsideProjectFindsBuildsAndRuns
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer/build
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_BUILD_TYPE=$<CONFIG> -DCMAKE_PREFIX_PATH=${consumer_prefix}
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    --test-command gnomon_consumer)
set_tests_properties(Install.AnOutsideProjectFindsBuildsAndRuns PROPERTIES
  FIXTURES_REQUIRED installed_gnomon LABELS install)
