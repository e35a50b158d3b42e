#include "apps/gnomon/output_place.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

/// Endings that say what a file holds; any other is the user's own affair.
constexpr std::array<std::string_view, 18> known_endings = {".csv",  ".json", ".vti", ".vtm",  ".vtpc", ".vtp",
                                                            ".vtu",  ".pvd",  ".obj", ".stl",  ".off",  ".ply",
                                                            ".gltf", ".glb",  ".png", ".html", ".svg",  ".pfm"};

std::string ending_of(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::count(known_endings, ending) > 0 ? ending : "";
}

bool fits_place(const std::string& name, OutputKind kind) {
  std::error_code ignored;
  const std::string ending = ending_of(name);
  switch (kind) {
    case OutputKind::folder:
      return name != "-" && (ending.empty() || fs::is_directory(name, ignored));
    case OutputKind::csv:
      return ending.empty() || ending == ".csv";
    case OutputKind::json:
      return ending.empty() || ending == ".json";
    case OutputKind::image:
      return fs::path(name).extension() == ".vti";
    case OutputKind::picture:
      return ending == ".png" || ending == ".pfm" || ending == ".vti";
    case OutputKind::text:
      return name != "-" && ending.empty();
  }
  return true;
}

/// Also of names that differ but lead to one file.
bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::absolute(a, ignored).lexically_normal() == fs::absolute(b, ignored).lexically_normal() ||
         fs::equivalent(a, b, ignored);
}

std::string place_for(OutputKind kind) {
  switch (kind) {
    case OutputKind::folder:
      return "a folder, for a result has many files (--json - writes one document to stdout)";
    case OutputKind::csv:
      return "a file that ends in .csv, or - for stdout";
    case OutputKind::json:
      return "a file that ends in .json, or - for stdout";
    case OutputKind::image:
      return "a file that ends in .vti, which ParaView opens; image data do not go to stdout";
    case OutputKind::picture:
      return "a file that ends in .png, .pfm or .vti";
    case OutputKind::text:
      return "a file of text, such as points.pts; it does not go to stdout";
  }
  return {};
}

}  // namespace

void require_place(std::string_view option, const std::string& name, OutputKind kind) {
  if (name.empty() || fits_place(name, kind)) return;
  throw UsageError(std::string(option) + ' ' + name + ": expected " + place_for(kind));
}

void require_unread(std::string_view option, const std::string& name, const std::vector<std::string>& read) {
  if (name.empty() || name == "-" || std::ranges::none_of(read, [&](const auto& r) { return is_one_file(name, r); })) {
    return;
  }
  throw UsageError(std::string(option) + ' ' + name + ": this file is read; expected another one to write");
}

void require_unwritten(std::string_view option, const std::string& name, const std::vector<std::string>& written) {
  if (name.empty()) return;
  for (const std::string& other : written) {
    if (other.empty() || other == "-" || !is_one_file(name, other)) continue;
    throw UsageError(std::string(option) + ' ' + name + ": another option writes this file, too; expected two");
  }
}

void require_table_places(const std::string& out, const std::string& json, const std::vector<std::string>& read) {
  require_place("--out", out, OutputKind::csv);
  require_place("--json", json, OutputKind::json);
  require_unread("--out", out, read);
  require_unread("--json", json, read);
  if (out.empty() || json.empty() || !is_one_file(out, json)) return;
  throw UsageError("--out " + out + " and --json " + json + " name one place; expected two");
}

void require_result_places(const std::string& folder, const std::string& json, const std::vector<std::string>& read) {
  require_place("--json", json, OutputKind::json);
  require_unread("--json", json, read);
  if (folder.empty()) return;
  require_place("--out", folder, OutputKind::folder);
  require_result_folder(folder);
  if (!json.empty() && is_one_file(json, (fs::path(folder) / "manifest.json").string())) {
    throw UsageError("--json " + json + ": the folder's list of files has this name; expected another");
  }
}

void warn_of_outdated_results(const std::string& folder) {
  for (const std::string& root : outdated_roots(folder)) {
    print_warning((fs::path(folder) / root).string() +
                  " is of another scene or box than what was written now; write it again");
  }
}

}  // namespace gnomon
