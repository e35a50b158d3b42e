#include "apps/gnomon/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/console.h"
#include "apps/keep_memory.h"
#include "geometry/scene/scene_reader.h"

namespace gnomon {
namespace {

const Command* command_called(const ProgramText& program, std::string_view name) {
  for (const std::span<const Command> commands : {program.commands, program.elsewhere}) {
    const auto found = std::ranges::find(commands, name, &Command::name);
    if (found != commands.end()) return &*found;
  }
  return nullptr;
}

std::vector<std::string_view> command_names(const ProgramText& program) {
  std::vector<std::string_view> names;
  for (const std::span<const Command> commands : {program.commands, program.elsewhere}) {
    for (const Command& command : commands) names.push_back(command.name);
  }
  return names;
}

void print_commands(std::ostream& stream, std::string_view title, std::span<const Command> commands) {
  if (commands.empty()) return;
  stream << '\n' << title << ":\n";
  for (const Command& command : commands) {
    stream << "  " << command.name << std::string(17 - command.name.size(), ' ') << command.does << '\n';
  }
}

void print_help(std::ostream& stream, const ProgramText& program) {
  const std::string name(program.name);
  stream << program.purpose << "\n\nUsage: " << name << " COMMAND [OPTIONS]\n";
  print_commands(stream, "Commands", program.commands);
  print_commands(stream, program.elsewhere_title, program.elsewhere);
  stream << "\nOptions:\n"
            "  -h, --help    print this text; '" +
                name +
                " COMMAND --help' says more about a command\n"
                "  --version     print the version\n\n"
                "Exit codes: 0 done, 1 failed while running, 2 wrong usage, 3 bad or missing scene or input line,\n"
                "4 not supported.\n\n"
                "Examples:\n"
         << program.examples;
}

ExitCode refuse(const ProgramText& program, const std::string& word) {
  if (word.starts_with("-")) throw UsageError("unknown option '" + word + "' in place of a command");
  const std::vector<std::string_view> names = command_names(program);
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  throw UsageError("there is no command '" + word + "'; the nearest is '" + std::string(nearest_word(word, names)) +
                   "', the commands are " + list);
}

ExitCode run(const ProgramText& program, Arguments words) {
  if (words.empty()) {
    print_help(std::cerr, program);
    return ExitCode::usage;
  }
  const std::string& first = words.front();
  if (first == "-h" || first == "--help") {
    print_help(std::cout, program);
    return ExitCode::done;
  }
  if (first == "--version") {
    std::cout << program.name << " " GNOMON_VERSION "\n";
    return ExitCode::done;
  }
  const Command* command = command_called(program, first);
  return command == nullptr ? refuse(program, first) : command->run(words.subspan(1));
}

ExitCode fail(ExitCode code, std::string_view message) {
  print_error(message);
  return code;
}

ExitCode misuse(const ProgramText& program, Arguments words, std::string_view message) {
  print_error(message);
  const bool known = !words.empty() && command_called(program, words.front()) != nullptr;
  std::cerr << "Try '" << program.name << ' ' << (known ? words.front() + " " : "") << "--help'.\n";
  return ExitCode::usage;
}

}  // namespace

int run_program(const ProgramText& program, int argc, char** argv) {
  keep_freed_memory();
  prepare_streams();
  ExitCode code = ExitCode::done;
  std::vector<std::string> words;
  try {
    words.assign(argv + std::min(argc, 1), argv + argc);
    code = run(program, words);
    finish_stdout();
  } catch (const UsageError& error) {
    code = misuse(program, words, error.what());
  } catch (const CLI::ParseError& error) {
    code = misuse(program, words, error.what());
  } catch (const UnsupportedSceneError& error) {
    code = fail(ExitCode::unsupported, error.what());
  } catch (const SceneError& error) {
    code = fail(ExitCode::bad_scene, error.what());
  } catch (const UnsupportedError& error) {
    code = fail(ExitCode::unsupported, error.what());
  } catch (const std::bad_alloc&) {
    code = fail(ExitCode::failure, "not enough memory");
  } catch (const std::exception& error) {
    code = fail(ExitCode::failure, error.what());
  }
  return static_cast<int>(code);
}

}  // namespace gnomon
