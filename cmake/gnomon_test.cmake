# gnomon_test(NAME LABEL label [CASES n] SOURCES file... LIBRARIES target...): one test executable and its CTest entries.
# RapidCheck draws from a fixed seed, which it prints; GNOMON_LONG_TESTS draws more.
# Tests labelled `unit` need neither a display nor ParaView; the target `unit_tests` builds them all.
include(GoogleTest)

if(GNOMON_LONG_TESTS)
  set(GNOMON_CASES 5000)
else()
  set(GNOMON_CASES 200)
endif()

if(NOT TARGET unit_tests)
  add_custom_target(unit_tests)
endif()

function(gnomon_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;CASES" "SOURCES;LIBRARIES")
  set(cases ${GNOMON_CASES})
  if(arg_CASES GREATER cases)
    set(cases ${arg_CASES})
  endif()
  add_executable(${name} ${arg_SOURCES})
  gnomon_target(${name})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock_main rapidcheck_gtest)
  gnomon_precompile(${name} <gmock/gmock.h> <gtest/gtest.h> <rapidcheck/gtest.h>)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${arg_LABEL} ENVIRONMENT "RC_PARAMS=seed=42 max_success=${cases}")
  if(arg_LABEL STREQUAL "unit")
    add_dependencies(unit_tests ${name})
  endif()
endfunction()
