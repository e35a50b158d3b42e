# gnomon_test(NAME LABEL label [CASES n] SOURCES file... LIBRARIES target...): one test executable and its CTest entries.
# RapidCheck draws n cases (200) from a fixed seed, which it prints; with GNOMON_LONG_TESTS ten times n, at least 5,000.
# Tests labelled `unit` need neither a display nor ParaView; the target `unit_tests` builds them all.
include(GoogleTest)

if(NOT TARGET unit_tests)
  add_custom_target(unit_tests)
endif()

function(gnomon_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;CASES" "SOURCES;LIBRARIES")
  set(cases 200)
  if(arg_CASES)
    set(cases ${arg_CASES})
  endif()
  if(GNOMON_LONG_TESTS)
    math(EXPR cases "10 * ${cases}")
    if(cases LESS 5000)
      set(cases 5000)
    endif()
  endif()
  add_executable(${name} ${arg_SOURCES})
  gnomon_target(${name})
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock_main rapidcheck_gtest)
  gnomon_precompile(${name} <gmock/gmock.h> <gtest/gtest.h> <rapidcheck/gtest.h>)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${arg_LABEL} ENVIRONMENT "RC_PARAMS=seed=42 max_success=${cases}")
  if(arg_LABEL STREQUAL "unit")
    add_dependencies(unit_tests ${name})
  endif()
endfunction()
