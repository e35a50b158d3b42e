#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/file_text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view scene_ending = ".scene.json";

/// Where the examples lie beside the program, installed or in a build.
fs::path example_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = (program.parent_path() / "../share/gnomon/examples").lexically_normal();
  if (!fs::is_directory(folder, error)) {
    throw std::runtime_error("the examples are not installed: there is no folder " + folder.string());
  }
  return folder;
}

/// The examples as they are asked for: scenes by their names, other files by theirs with ending; those of folders after
/// all others, as FOLDER/NAME.
std::vector<std::string> example_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    std::string name = entry.path().lexically_relative(folder).string();
    if (name.ends_with(scene_ending)) name.resize(name.size() - scene_ending.size());
    if (entry.is_regular_file() && entry.path().extension() != ".license") names.push_back(std::move(name));
  }
  const auto is_in_folder = [](const std::string& name) { return name.find('/') != std::string::npos; };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair(is_in_folder(a), a) < std::pair(is_in_folder(b), b);
  });
  return names;
}

/// An example's name without its folder will do.
std::string file_of(const std::string& name, const fs::path& folder) {
  const std::vector<std::string> names = example_names(folder);
  const bool is_written_out = name.ends_with(scene_ending);
  std::string wanted = is_written_out ? name.substr(0, name.size() - scene_ending.size()) : name;
  const auto is_wanted = [&](const std::string& n) { return n == wanted || n.ends_with('/' + wanted); };
  const auto found = std::find_if(names.begin(), names.end(), is_wanted);
  if (found != names.end()) {
    wanted = *found;
  } else {
    const std::vector<std::string_view> words(names.begin(), names.end());
    throw UsageError("there is no example '" + name + "'" + nearest_text(wanted, words) +
                     "; 'gnomon example' lists them all");
  }
  std::error_code ignored;
  return fs::is_regular_file(folder / wanted, ignored) ? wanted : wanted + std::string(scene_ending);
}

bool is_scene(const std::string& file) {
  return file.ends_with(scene_ending);
}

/// The mesh files that a scene needs beside it.
std::vector<std::string> needed_files(const std::string& file, const fs::path& folder) {
  std::vector<std::string> files;
  if (!is_scene(file)) return files;
  const Scene scene = read_scene(folder / file);
  const auto* space = std::get_if<SpaceScene>(&scene);
  if (!space) return files;
  for (const SceneBlocker& blocker : space->blockers) {
    const auto* mesh = std::get_if<Mesh>(&blocker.shape);
    if (mesh == nullptr) continue;
    const std::string needed = (fs::path(file).parent_path() / mesh->file).string();
    if (std::find(files.begin(), files.end(), needed) == files.end()) files.push_back(needed);
  }
  return files;
}

std::string contents_of(const fs::path& file) {
  FileText text = file_text(file, std::size_t{1} << 26U, FileKind::regular);
  if (!text.problem.empty()) throw std::runtime_error("cannot read " + file.string() + ": found " + text.problem);
  return std::move(text.text);
}

void print_list(const fs::path& folder) {
  std::vector<TextRow> rows;
  for (const std::string& name : example_names(folder)) {
    const std::string file = file_of(name, folder);
    if (!is_scene(file)) {
      if (name.find('/') == std::string::npos) rows.push_back({name, "a file that examples use"});
      continue;
    }
    const Scene scene = read_scene(folder / file);
    const bool planar = std::holds_alternative<PlaneScene>(scene);
    rows.push_back({name, lights_and_blockers(scene) + (planar ? ", in the plane" : ", in space")});
  }
  std::cout << aligned(rows, 0);
}

/// A file that is there already stays, unless it is the same.
void copy_example(const fs::path& source, const fs::path& target) {
  const std::string text = contents_of(source);
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(target, ignored))) {
    if (fs::is_regular_file(target, ignored) && contents_of(target) == text) return;
    throw std::runtime_error("cannot write " + target.string() + ": another file of that name is there");
  }
  write_output_file(target, text);
}

void copy_examples(const std::vector<std::string>& files, const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to, error);
  if (error) throw std::runtime_error("cannot create the folder " + to.string() + ": " + error.message());
  const auto place = [&](const std::string& file) { return to / fs::path(file).filename(); };
  for (const std::string& file : files) copy_example(from / file, place(file));
  for (const std::string& file : files) std::cout << "written    " << shell_word(place(file).string()) << '\n';
}

void print_example(const std::string& name, const std::vector<std::string>& files, const fs::path& folder) {
  std::cout << contents_of(folder / files.front());
  if (files.size() == 1) return;
  const std::string needed = fs::path(files[1]).filename().string();
  const std::string more = files.size() == 2 ? needed : needed + " and " + counted(files.size() - 2, "more file");
  print_warning(name + " needs " + more + " beside it; 'gnomon example " + name + " --out DIR' copies all");
}

}  // namespace

ExitCode example_command(Arguments arguments) {
  CommandLine app("Prints an example that is installed with the program, or the list of them.", "gnomon example");
  std::string name, out;
  add_text(app, "NAME", name, "NAME", "A scene, or another file, of the list; without it the list");
  add_text(app, "--out", out, "DIR", "Copy the example into this folder, with the files that it needs");
  app.footer(
      "Examples:\n"
      "  gnomon example\n"
      "  gnomon example letter_block --out examples_of_gnomon\n");
  if (!app.parse(arguments)) return ExitCode::done;
  if (name.empty() && !out.empty()) throw UsageError("--out copies an example: name one");
  const fs::path folder = example_folder();
  if (name.empty()) {
    print_list(folder);
    return ExitCode::done;
  }
  std::vector<std::string> files = {file_of(name, folder)};
  for (const std::string& needed : needed_files(files.front(), folder)) files.push_back(needed);
  if (out.empty()) {
    print_example(name, files, folder);
  } else {
    copy_examples(files, folder, out);
  }
  return ExitCode::done;
}

}  // namespace gnomon
