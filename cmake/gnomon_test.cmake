# gnomon_test(NAME LABEL label [CASES filter=n...] SOURCES file... LIBRARIES target...): one test executable and its
# CTest entries. RapidCheck draws 200 cases from a fixed seed, which it prints, and n cases in tests that match a filter
# of GoogleTest's; with GNOMON_LONG_TESTS ten times as many, at least 5,000.
# Tests labelled `unit` need neither a display nor ParaView; the target `unit_tests` builds them all.
include(GoogleTest)

if(NOT TARGET unit_tests)
  add_custom_target(unit_tests)
endif()

# Tests are compiled often and run once, and their heavy work is in the libraries: they are optimised less.
function(gnomon_tested name)
  gnomon_target(${name})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

function(gnomon_discover name label cases filter)
  if(GNOMON_LONG_TESTS)
    math(EXPR cases "10 * ${cases}")
    if(cases LESS 5000)
      set(cases 5000)
    endif()
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_FILTER "${filter}"
    PROPERTIES LABELS ${label} ENVIRONMENT "RC_PARAMS=seed=42 max_success=${cases}")
endfunction()

function(gnomon_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "CASES;SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  gnomon_tested(${name})
  gnomon_unity(${name} 6)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock_main rapidcheck_gtest)
  set(others "")
  foreach(entry IN LISTS arg_CASES)
    string(REPLACE "=" ";" pair "${entry}")
    list(GET pair 0 filter)
    list(GET pair 1 cases)
    gnomon_discover(${name} ${arg_LABEL} ${cases} "${filter}")
    string(APPEND others ":${filter}")
  endforeach()
  string(REGEX REPLACE "^:" "-" others "${others}")
  gnomon_discover(${name} ${arg_LABEL} 200 "${others}")
  if(arg_LABEL STREQUAL "unit")
    add_dependencies(unit_tests ${name})
  endif()
endfunction()
