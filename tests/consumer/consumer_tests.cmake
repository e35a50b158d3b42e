# Installs the build into a folder of the build tree; then an outside project finds it there, is built and run.
set(consumer_folder ${CMAKE_CURRENT_BINARY_DIR}/consumer)

add_test(NAME Install.StartsFromAnEmptyFolder COMMAND ${CMAKE_COMMAND} -E rm -rf ${consumer_folder})
add_test(NAME Install.CopiesProgramLibrariesHeadersAndPackage
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${consumer_folder}/prefix)
add_test(NAME Install.AnOutsideProjectFindsBuildsAndRuns
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${consumer_folder}/build
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_BUILD_TYPE=$<CONFIG> -DCMAKE_PREFIX_PATH=${consumer_folder}/prefix
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    --test-command gnomon_consumer)

set_tests_properties(Install.StartsFromAnEmptyFolder PROPERTIES FIXTURES_SETUP empty_folder)
set_tests_properties(Install.CopiesProgramLibrariesHeadersAndPackage PROPERTIES
  FIXTURES_REQUIRED empty_folder FIXTURES_SETUP installed_gnomon)
set_tests_properties(Install.AnOutsideProjectFindsBuildsAndRuns PROPERTIES FIXTURES_REQUIRED installed_gnomon)
set_property(TEST Install.StartsFromAnEmptyFolder Install.CopiesProgramLibrariesHeadersAndPackage
  Install.AnOutsideProjectFindsBuildsAndRuns PROPERTY LABELS install)
