# gnomon_target(NAME): what every target of the project has in common.
# Floating point is used exactly as written: filters and error bounds rely on it.
function(gnomon_target name)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/gnomon>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What g++ 12 gets wrong in headers not ours: std::optional of a GMP number, and std::string's operator+.
    target_compile_options(${name} PRIVATE -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow)
  endif()
  if(GNOMON_WARNINGS_AS_ERRORS)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
endfunction()

# gnomon_precompile(NAME header...): reads heavy headers once per target, which shortens a first build by a third.
# With ccache nothing is precompiled: it would miss where it otherwise hits.
function(gnomon_precompile name)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${name} PRIVATE ${ARGN})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Precompiled, std::string is no system header any more to g++ 12, which then warns of what it gets wrong there.
      target_compile_options(${name} PRIVATE -Wno-array-bounds)
    endif()
  endif()
endfunction()
