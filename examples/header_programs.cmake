# Every header of include/gnomon opens with a program of at most ten lines, which returns 0 if what it claims holds. Here
# they are cut out of the comments, built and run: one executable, to which the header's name is given. gnomon.h names all.
set(program_folder ${CMAKE_CURRENT_BINARY_DIR}/header_programs)
set(header_folder ${PROJECT_SOURCE_DIR}/include/gnomon)
file(STRINGS ${header_folder}/gnomon.h program_names REGEX "^#include")
list(TRANSFORM program_names REPLACE "#include \"gnomon/(.+)\\.h\"" "\\1")
list(APPEND program_names gnomon)
set(program_sources "")
set(declared "")
set(called "")
foreach(name IN LISTS program_names)
  set(header ${header_folder}/${name}.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(READ ${header} text)
  string(REGEX MATCH "(\n///     [^\n]*)+" program "${text}")
  string(REGEX MATCHALL "\n" line_ends "${program}")
  list(LENGTH line_ends count)
  if(count EQUAL 0 OR count GREATER 10)
    message(FATAL_ERROR "${header} has to open with a program of at most ten lines, and has ${count}")
  endif()
  string(REPLACE "\n///     " "\n" program "${program}")
  string(REPLACE "int main()" "int ${name}_program()" program "${program}")
  file(CONFIGURE OUTPUT ${program_folder}/${name}.cpp CONTENT "int ${name}_program();\n@program@\n" @ONLY)
  list(APPEND program_sources ${program_folder}/${name}.cpp)
  string(APPEND declared "int ${name}_program();\n")
  string(APPEND called "  if (name == \"${name}\") return ${name}_program();\n")
endforeach()
file(CONFIGURE OUTPUT ${program_folder}/main.cpp @ONLY CONTENT "#include <string_view>
@declared@
int main(int, char** argv) {
  const std::string_view name = argv[1];
@called@  return 2;
}
")
add_executable(header_programs ${program_sources} ${program_folder}/main.cpp)
gnomon_target(header_programs)
set_target_properties(header_programs PROPERTIES UNITY_BUILD OFF)
target_link_libraries(header_programs PRIVATE gnomon::inverse gnomon::scene gnomon::shading gnomon::viz)
foreach(name IN LISTS program_names)
  add_test(NAME header_program_${name} COMMAND header_programs ${name} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(header_program_${name} PROPERTIES LABELS examples)
endforeach()
