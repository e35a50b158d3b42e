#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/gnomon/commands.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr const char* proof_program = "gnomon-proof";

/// Where gnomon-proof may be: beside this program, then in the folders of the path.
std::vector<fs::path> proof_places() {
  std::vector<fs::path> places;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (!error) places.push_back(self.parent_path() / proof_program);
  const char* variable = std::getenv("PATH");
  std::string path = variable == nullptr ? "" : variable;
  while (!path.empty()) {
    const std::size_t colon = std::min(path.find(':'), path.size());
    if (colon > 0) places.push_back(fs::path(path.substr(0, colon)) / proof_program);
    path.erase(0, colon + 1);
  }
  return places;
}

}  // namespace

ExitCode proof_command(const std::string& command, Arguments arguments) {
  std::vector<std::string> words = {proof_program, command};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  for (const fs::path& place : proof_places()) {
    if (access(place.c_str(), X_OK) != 0) continue;
    execv(place.c_str(), argv.data());
    throw std::runtime_error("cannot start " + place.string() + ": " + std::strerror(errno));
  }
  throw UnsupportedError(
      "'gnomon " + command +
      "' is run by gnomon-proof, which is neither beside gnomon nor on the path; it is in the Debian "
      "package gnomon-proof, or built with -DGNOMON_PROOF=ON");
}

}  // namespace gnomon
