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

# The installed program finds the installed examples, and the pages are there.
add_test(NAME Install.BringsExamples COMMAND ${consumer_folder}/prefix/bin/gnomon example figure_4_22)
add_test(NAME Install.BringsPages COMMAND ${CMAKE_COMMAND} -E md5sum README.md CHANGELOG.md CITATION.cff docs/tutorial.md
  docs/pictures/figure_4_22.png geometry/references.md)
set_tests_properties(Install.BringsPages PROPERTIES
  WORKING_DIRECTORY ${consumer_folder}/prefix/${CMAKE_INSTALL_DATADIR}/doc/gnomon)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME Install.BringsPagesWithoutDeadLinks COMMAND ${Python3_EXECUTABLE}
  ${CMAKE_CURRENT_SOURCE_DIR}/docs/dead_links.py ${consumer_folder}/prefix/${CMAKE_INSTALL_DATADIR}/doc/gnomon)
set_tests_properties(Install.BringsExamples Install.BringsPages Install.BringsPagesWithoutDeadLinks PROPERTIES LABELS install
  FIXTURES_REQUIRED installed_gnomon)

# gnomon_refusal_test(NAME SAYS regular-expression OPTIONS option...): a project that needs gnomon::viz is told why it
# cannot have it.
function(gnomon_refusal_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SAYS" "OPTIONS")
  add_test(NAME ${name}
    COMMAND ${CMAKE_COMMAND} --fresh -S ${CMAKE_CURRENT_SOURCE_DIR}/consumer/viz -B ${consumer_folder}/${name}
      -G ${CMAKE_GENERATOR} -DCMAKE_PREFIX_PATH=${consumer_folder}/prefix -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      ${arg_OPTIONS})
  # CMake breaks its messages into lines.
  string(REPLACE " " "[ \n]+" says "${arg_SAYS}")
  set_tests_properties(${name} PROPERTIES LABELS install FIXTURES_REQUIRED installed_gnomon
    PASS_REGULAR_EXPRESSION "${says}")
endfunction()

gnomon_refusal_test(Install.SaysThatVtkNeedsTheLanguageC
  SAYS "there is no gnomon::viz: VTK's modules need the language C" OPTIONS -DLANGUAGES=CXX)
gnomon_refusal_test(Install.SaysThatVtkIsNotThere
  SAYS "there is no gnomon::viz: VTK 9.1 or later" OPTIONS "-DLANGUAGES=C$<SEMICOLON>CXX"
    -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON)

set_tests_properties(Install.StartsFromAnEmptyFolder PROPERTIES FIXTURES_SETUP empty_folder)
set_tests_properties(Install.CopiesProgramLibrariesHeadersAndPackage PROPERTIES
  FIXTURES_REQUIRED empty_folder FIXTURES_SETUP installed_gnomon)
set_tests_properties(Install.AnOutsideProjectFindsBuildsAndRuns PROPERTIES FIXTURES_REQUIRED installed_gnomon)
set_property(TEST Install.StartsFromAnEmptyFolder Install.CopiesProgramLibrariesHeadersAndPackage
  Install.AnOutsideProjectFindsBuildsAndRuns PROPERTY LABELS install)
