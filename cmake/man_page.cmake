# cmake -DPROGRAM=gnomon -DVERSION=1.2.3 -DOUT=gnomon.1 -P man_page.cmake
# Writes the manual page from what the program says of itself: its own help, then that of every command it runs itself.
function(help_of out)
  execute_process(COMMAND ${PROGRAM} ${ARGN} --help OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# Lines are the program's own, at most 80 columns wide, and stay as they are, at the left edge so that they fit. Options
# and what they do become paragraphs.
function(roff out text)
  string(REPLACE "\\" "\\(rs" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REPLACE "\n." "\n\\&." text "${text}")
  string(REPLACE "\n'" "\n\\&'" text "${text}")
  # An option's help begins below a long name, and goes on in lines that begin far to the right.
  string(REGEX REPLACE "\n  (\\\\-[^ \n]+( [^ \n]+)*)\n                         +([^ \n])" "\n  \\1  \\3" text "${text}")
  set(before "")
  while(NOT text STREQUAL before)
    set(before "${text}")
    string(REGEX REPLACE "(\n  \\\\-[^\n]*)\n                         +([^ \n])" "\\1 \\2" text "${text}")
  endwhile()
  string(REGEX REPLACE "\n  (\\\\-[^ \n]+( [^ \n]+)*)  +([^\n]+)"
    "\n.fi\n.in\n.TP\n.B \\1\n\\3\n.PP\n.in 0\n.nf" text "${text}")
  set(${out} ".in 0\n.nf\n${text}.fi\n.in\n" PARENT_SCOPE)
endfunction()

help_of(main)
string(REGEX MATCH "Commands:\n(  [^\n]*\n)+" list "${main}")
string(REGEX MATCHALL "\n  [a-z-]+" commands "${list}")

cmake_path(GET PROGRAM FILENAME name)
string(TOUPPER ${name} heading)
string(REPLACE "-" "\\-" name "${name}")
roff(body "${main}")
string(CONCAT page ".TH ${heading} 1 \"\" \"gnomon ${VERSION}\" \"User Commands\"\n"
  ".SH NAME\n${name} \\- exact shadow geometry\n"
  ".SH SYNOPSIS\n.B ${name}\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" "${body}")
foreach(command IN LISTS commands)
  string(STRIP "${command}" command)
  help_of(text ${command})
  roff(body "${text}")
  string(TOUPPER ${command} title)
  string(APPEND page ".SH GNOMON ${title}\n" "${body}")
endforeach()
file(WRITE ${OUT} "${page}")
