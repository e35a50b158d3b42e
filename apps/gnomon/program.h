#pragma once

#include <span>
#include <string_view>

#include "apps/gnomon/commands.h"

namespace gnomon {

struct Command {
  std::string_view name;
  std::string_view does;
  ExitCode (*run)(Arguments);
  bool shares_work = false;  ///< among the processes that mpirun starts
};

/// A program of several commands, as its help describes it.
struct ProgramText {
  std::string_view name;
  std::string_view purpose;  ///< one sentence
  std::span<const Command> commands;
  std::string_view elsewhere_title;    ///< of the list of commands that another program runs
  std::span<const Command> elsewhere;  ///< may be empty
  std::string_view examples;           ///< two lines
};

/// Runs the command that the arguments name; prints help, version and errors.
///
/// Returns: the exit code.
int run_program(const ProgramText& program, int argc, char** argv);

}  // namespace gnomon
