# gnomon_target(NAME): what every target of the project has in common.
# Floating point is used exactly as written: filters and error bounds rely on it.
function(gnomon_target name)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What g++ 12 gets wrong in headers not ours: std::optional of a GMP number, and std::string's operator+.
    target_compile_options(${name} PRIVATE -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow)
    # A batch of a unity build is no header, but g++ takes the files in it for headers.
    target_compile_options(${name} PRIVATE -Wno-subobject-linkage)
    # Up to this much memory g++ does not look for what it may free; that spares a sixth of its time.
    target_compile_options(${name} PRIVATE "SHELL:--param ggc-min-heapsize=800000")
  endif()
  if(GNOMON_WARNINGS_AS_ERRORS)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
endfunction()

# gnomon_shareable(LIBRARY): the Python module, a shared object, may contain the library. Its functions are not to be
# replaced by others of the same name, so calls within the library stay direct, and may be inlined.
function(gnomon_shareable name)
  if(GNOMON_PYTHON)
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${name} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()

# gnomon_allocator(PROGRAM): the program takes memory by oneTBB's allocator, in place of the C library's. Exact numbers come
# and go by the million, and meshes one after the other. Sanitizers bring an allocator of their own.
function(gnomon_allocator program)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_libraries(${program} PRIVATE -Wl,--push-state,--no-as-needed TBB::tbbmalloc_proxy -Wl,--pop-state)
  endif()
endfunction()

# gnomon_precompile(NAME header...): reads heavy headers once per target, which pays where many batches need them.
# With ccache nothing is precompiled: it would miss where it otherwise hits.
function(gnomon_precompile name)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
    target_precompile_headers(${name} PRIVATE ${ARGN})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Precompiled, std::string is no system header any more to g++ 12, which then warns of what it gets wrong there.
      target_compile_options(${name} PRIVATE -Wno-array-bounds)
    endif()
  endif()
endfunction()

# gnomon_unity(NAME SIZE): the target's sources are compiled in batches of at most SIZE neighbours of one folder, so that
# headers are read once a batch. Files of a batch share their anonymous namespaces: names in these differ within a batch.
function(gnomon_unity name size)
  get_target_property(sources ${name} SOURCES)
  set(last_folder "none")
  set(batch 0)
  set(count 0)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    if(NOT folder STREQUAL last_folder OR count GREATER_EQUAL size)
      math(EXPR batch "${batch} + 1")
      set(count 0)
      set(last_folder "${folder}")
    endif()
    math(EXPR count "${count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${batch})
  endforeach()
  set_target_properties(${name} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# gnomon_man_page(PROGRAM): man/PROGRAM.1 in the build folder, from what the program says of itself.
function(gnomon_man_page program)
  set(man_page ${PROJECT_BINARY_DIR}/man/${program}.1)
  add_custom_command(OUTPUT ${man_page} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DVERSION=${PROJECT_VERSION} -DOUT=${man_page}
      -P ${PROJECT_SOURCE_DIR}/cmake/man_page.cmake
    DEPENDS ${program} ${PROJECT_SOURCE_DIR}/cmake/man_page.cmake)
  add_custom_target(${program}_man_page ALL DEPENDS ${man_page})
endfunction()
