#include "tests/apps/gnomon/program_fixture.h"

#include "tests/support/json_schema.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder() {
  std::string pattern = (fs::temp_directory_path() / "gnomon-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return pattern;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What the program writes as JSON follows the schema that it names; keys that no schema lists count as mistakes.
void expect_schema(const std::string& text) {
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object() || !document.contains("schema")) return;
  const std::string name = document["schema"];
  ASSERT_TRUE(name.starts_with("gnomon/") && name.ends_with("/1")) << name;
  const std::string file = GNOMON_SCHEMAS "/" + name.substr(7, name.size() - 9) + ".schema.json";
  const std::string violation =
      schema_violation(document, nlohmann::json::parse(contents(file)), UnlistedKeys::refused);
  EXPECT_EQ(violation, "") << file;
}

/// A scene that the program takes follows the schema of scenes.
void expect_scene_schema(const std::string& arguments, const fs::path& folder) {
  std::istringstream words(arguments);
  for (std::string word; words >> word;) {
    if (!word.ends_with(".scene.json") || !fs::is_regular_file(folder / word)) continue;
    const nlohmann::json scene = nlohmann::json::parse(contents(folder / word));
    EXPECT_EQ(schema_violation(scene, nlohmann::json::parse(contents(GNOMON_SCHEMAS "/scene.schema.json"))), "")
        << word;
  }
}

}  // namespace

Program::Program(Display display) : display_(display), folder_(fresh_folder()) {
  fs::create_directory(folder_ / "run");
  fs::create_directory_symlink(GNOMON_EXAMPLES, folder_ / "run" / "examples");
}

Program::~Program() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome Program::gnomon(const std::string& arguments) const {
  const Outcome outcome = shell("\"$GNOMON\" " + arguments);
  if (outcome.code == 0) expect_scene_schema(arguments, folder_ / "run");
  return outcome;
}

Outcome Program::shell(const std::string& command) const {
  // What is captured lies outside of the folder that the program sees.
  const std::string out = (folder_ / "out").string();
  const std::string err = (folder_ / "err").string();
  const std::string prepare = "cd '" + (folder_ / "run").string() + "' && GNOMON='" GNOMON_PROGRAM "' && ";
  const std::string hide = display_ == Display::hidden ? "unset DISPLAY && " : "";
  const std::string all = prepare + hide + "{ " + command + "\n} </dev/null >'" + out + "' 2>'" + err + "'";
  const int status = std::system(all.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  Outcome outcome{code, contents(out), contents(err)};
  expect_schema(outcome.out);
  return outcome;
}

nlohmann::json Program::read_json(const std::string& file) const {
  const std::string text = read(file);
  expect_schema(text);
  return nlohmann::json::parse(text);
}

void Program::write(const std::string& file, const std::string& text) const {
  std::ofstream(folder_ / "run" / file, std::ios::binary) << text;
}

std::string Program::read(const std::string& file) const {
  return contents(folder_ / "run" / file);
}

std::vector<std::string> Program::names_in(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / "run" / folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::vector<std::string> commands_of(const std::string& help) {
  std::istringstream rest(help.substr(std::min(help.find("Commands:\n"), help.size())));
  std::string line;
  std::getline(rest, line);
  std::vector<std::string> found;
  while (std::getline(rest, line) && line.starts_with("  ")) found.push_back(line.substr(2, line.find(' ', 2) - 2));
  return found;
}

std::vector<std::string> options_of(const std::string& help) {
  std::istringstream rest(help);
  std::vector<std::string> found;
  for (std::string line; std::getline(rest, line);) {
    const std::size_t start = line.starts_with("  -h,") ? 5 : 2;
    if (!line.starts_with("  -") || line.substr(start, 2) != "--") continue;
    found.push_back(line.substr(start, line.find_first_of(" ,", start) - start));
  }
  return found;
}

std::vector<std::string> examples_of(const std::string& help) {
  std::istringstream rest(help.substr(std::min(help.find("Examples:"), help.size())));
  const std::string start = "  gnomon ";
  std::vector<std::string> found;
  for (std::string line; std::getline(rest, line);) {
    if (line.starts_with(start)) found.push_back(line.substr(start.size()));
  }
  return found;
}

}  // namespace gnomon
