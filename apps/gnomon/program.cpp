#include "apps/gnomon/program.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/started_processes.h"
#include "apps/gnomon/text.h"
#include "apps/gnomon/untimely_end.h"
#include "gnomon/errors.h"
#include "gnomon/scene.h"

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

std::string command_list(std::string_view title, std::span<const Command> commands) {
  if (commands.empty()) return {};
  std::string text = '\n' + std::string(title) + ":\n";
  for (const Command& command : commands) {
    text.append("  ").append(command.name).append(17 - command.name.size(), ' ').append(command.does) += '\n';
  }
  return text;
}

void print_help(std::ostream& stream, const ProgramText& program) {
  const std::string name(program.name);
  stream << in_columns(std::string(program.purpose) + "\n\nUsage: " + name + " COMMAND [OPTIONS]\n" +
                       command_list("Commands", program.commands) +
                       command_list(program.elsewhere_title, program.elsewhere) +
                       "\nOptions:\n"
                       "  -h, --help    print this text; '" +
                       name +
                       " COMMAND --help' tells more\n"
                       "  --version     print the version\n\n"
                       "Exit codes: 0 done, 1 failed while running, 2 wrong usage, 3 bad or missing scene, result or "
                       "input line, 4 not supported, 5 not feasible though expected.\n\n"
                       "Examples:\n" +
                       std::string(program.examples));
}

/// The names of the commands that several processes may share.
std::string work_sharers(const ProgramText& program) {
  std::string names;
  for (const Command& command : program.commands) {
    if (command.shares_work) names += (names.empty() ? "" : ", ") + std::string(command.name);
  }
  return names.empty() ? "one process" : "one process, or one of the commands " + names;
}

ExitCode refuse(const ProgramText& program, const std::string& word) {
  if (word.starts_with("-")) throw UsageError("unknown option '" + word + "' in place of a command");
  const std::vector<std::string_view> names = command_names(program);
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  throw UsageError("there is no command '" + word + "'" + nearest_text(word, names) + "; the commands are " + list);
}

ExitCode run(const ProgramText& program, Arguments words) {
  const std::uint32_t processes = started_processes().count;
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
  if (command == nullptr) return refuse(program, first);
  if (!command->shares_work && processes > 1) {
    throw UsageError("mpirun started " + std::to_string(processes) + " processes, but '" + first +
                     "' runs in one; expected " + work_sharers(program));
  }
  return command->run(words.subspan(1));
}

/// A system that has no room for another thread says so in words that help nobody.
std::string system_message(const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) return error.what();
  return "no more threads can be started, for lack of memory or of processes; fewer can be asked for with --threads";
}

ExitCode fail(ExitCode code, std::string_view message) {
  wait_if_interrupted();
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
  prepare_streams();
  prepare_untimely_end();
  ExitCode code = ExitCode::done;
  std::vector<std::string> words;
  try {
    words.assign(argv + std::min(argc, 1), argv + argc);
    code = run(program, words);
    finish_stdout();
  } catch (const UsageError& error) {
    code = misuse(program, words, error.what());
  } catch (const UnsupportedSceneError& error) {
    code = fail(ExitCode::unsupported, error.what());
  } catch (const SceneError& error) {
    code = fail(ExitCode::bad_scene, error.what());
  } catch (const ResultError& error) {
    code = fail(ExitCode::bad_scene, error.what());
  } catch (const UnsupportedError& error) {
    code = fail(ExitCode::unsupported, error.what());
  } catch (const ReaderGone&) {
    code = ExitCode::done;  // as in `gnomon check SCENE | head`: whoever read has read enough
  } catch (const std::bad_alloc&) {
    code = fail(ExitCode::failure, "not enough memory");
  } catch (const std::length_error&) {
    code = fail(ExitCode::failure, "not enough memory for something that large");
  } catch (const std::system_error& error) {
    code = fail(ExitCode::failure, system_message(error));
  } catch (const std::exception& error) {
    code = fail(ExitCode::failure, error.what());
  }
  return static_cast<int>(end_processes(code));
}

}  // namespace gnomon
