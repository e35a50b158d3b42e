#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/keep_memory.h"
#include "geometry/scene/scene_reader.h"

namespace gnomon {
namespace {

struct Command {
  std::string_view name;
  std::string_view does;
  ExitCode (*run)(Arguments);
};

constexpr std::array commands{
    Command{"shadow", "extremal planes and occlusion, umbra and penumbra volumes, for ParaView", shadow_command},
    Command{"check", "validates a scene and prints what was recognised", check_command},
    Command{"regions", "tells region and visible fraction of every light at given points", regions_command},
    Command{"grid", "tells the same for the points of a grid, as VTK image data", grid_command},
    Command{"irradiance", "tells the irradiance that every light gives to given points and normals",
            irradiance_command},
    Command{"discontinuities", "surfaces across which what is visible of a light changes its formula",
            discontinuities_command},
    Command{"receivers", "regions and discontinuity mesh on every receiver", receivers_command},
    Command{"render", "makes a picture of a scene or of a result folder", render_command},
    Command{"theorems", "checks every numbered statement of the theory, and refutes the false ones", theorems_command},
    Command{"report", "measures speed against error and tries hard cases, with plots", report_command},
};

std::string command_list() {
  std::string list;
  for (const Command& command : commands) list += (list.empty() ? "" : ", ") + std::string(command.name);
  return list;
}

void print_help(std::ostream& stream) {
  stream << "gnomon computes exact shadow volumes of lights behind convex blockers, and hands them to ParaView.\n\n"
            "Usage: gnomon COMMAND [OPTIONS]\n\nCommands:\n";
  for (const Command& command : commands) {
    stream << "  " << command.name << std::string(17 - command.name.size(), ' ') << command.does << '\n';
  }
  stream << "\nOptions:\n"
            "  -h, --help    print this text; 'gnomon COMMAND --help' says more about a command\n"
            "  --version     print the version\n\n"
            "Exit codes: 0 done, 1 failed while running, 2 wrong usage, 3 bad or missing scene or input line,\n"
            "4 not supported.\n\n"
            "Examples:\n"
            "  gnomon shadow --out shadow_of_default\n"
            "  gnomon check examples/cornell_box.scene.json\n";
}

ExitCode refuse(const std::string& word) {
  if (word.starts_with("-")) throw UsageError("unknown option '" + word + "' in place of a command");
  std::vector<std::string_view> names;
  names.reserve(std::size(commands));
  for (const Command& command : commands) names.push_back(command.name);
  throw UsageError("there is no command '" + word + "'; the nearest is '" + std::string(nearest_word(word, names)) +
                   "', the commands are " + command_list());
}

ExitCode run(Arguments words) {
  if (words.empty()) {
    print_help(std::cerr);
    return ExitCode::usage;
  }
  const std::string& first = words.front();
  if (first == "-h" || first == "--help") {
    print_help(std::cout);
    return ExitCode::done;
  }
  if (first == "--version") {
    std::cout << "gnomon " GNOMON_VERSION "\n";
    return ExitCode::done;
  }
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const Command& c) { return c.name == first; });
  return found == commands.end() ? refuse(first) : found->run(words.subspan(1));
}

ExitCode fail(ExitCode code, std::string_view message) {
  print_error(message);
  return code;
}

ExitCode misuse(const Arguments words, std::string_view message) {
  print_error(message);
  const bool known = !words.empty() && std::any_of(commands.begin(), commands.end(),
                                                   [&](const Command& c) { return c.name == words.front(); });
  std::cerr << "Try 'gnomon " << (known ? words.front() + " " : "") << "--help'.\n";
  return ExitCode::usage;
}

}  // namespace
}  // namespace gnomon

int main(int argc, char** argv) {
  using namespace gnomon;
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "receivers" || command == "theorems") start_with_large_thread_caches(argv);
  keep_freed_memory();
  prepare_streams();
  ExitCode code = ExitCode::done;
  std::vector<std::string> words;
  try {
    words.assign(argv + std::min(argc, 1), argv + argc);
    code = run(words);
    finish_stdout();
  } catch (const UsageError& error) {
    code = misuse(words, error.what());
  } catch (const CLI::ParseError& error) {
    code = misuse(words, error.what());
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
