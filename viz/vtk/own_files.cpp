#include "viz/vtk/own_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a file; a block file names its field arrays in them, before its numbers.
std::string head(const fs::path& file) {
  std::string text(std::size_t{1} << 16, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return text;
}

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// "shadow" and "shadow_0012", where leaves lie.
bool is_leaf_folder(std::string_view name) {
  constexpr std::string_view stem = "shadow";
  if (!name.starts_with(stem)) return false;
  name.remove_prefix(stem.size());
  return name.empty() || (name.size() > 1 && name[0] == '_' && name.find_first_not_of("0123456789", 1) == name.npos);
}

}  // namespace

std::string way_out(const fs::path& directory, const fs::path& relative) {
  if (relative.empty() || relative.is_absolute() || std::ranges::count(relative, fs::path("..")) > 0) {
    return "its name leads out of the folder";
  }
  fs::path place = directory;
  for (const fs::path& part : relative.parent_path()) {
    place /= part;
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(place, ignored);
    if (fs::is_symlink(status)) return place.string() + " is a link, which may lead out of the folder";
    if (fs::exists(status) && !fs::is_directory(status)) return place.string() + " is no folder";
  }
  return {};
}

bool says_it_is_ours(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return false;
  const std::string text = head(file);
  const std::string name = file.extension().string();
  if (name == ".json") return holds(text.substr(0, 100), "\"schema\": \"gnomon/");
  if (name == ".py") return text.starts_with("\"\"\"Shows the result that lies beside this file in ParaView.\n");
  if (name == ".obj") return text.starts_with("# gnomon ");
  if (name == ".gltf") return holds(text.substr(0, 200), "\"generator\":\"gnomon ");
  if (name == ".stl") return text.starts_with("solid ") && holds(text, "\nfacet normal ");
  if (name == ".vtm" || name == ".vtpc" || name == ".pvd") return holds(text, "<!-- gnomon ");
  return holds(text, "Name=\"producer\"") && holds(text, "Name=\"length_unit\"") && holds(text, "Name=\"clip_box\"");
}

bool may_be_ours(const fs::path& relative) {
  constexpr std::array<std::string_view, 13> roots = {
      "view.py",          "shadow.vtm",          "shadow.vtpc",          "shadow.vtp",
      "shadow.obj",       "shadow.gltf",         "shadow.pvd",           "receivers.vtm",
      "receivers.vtpc",   "discontinuities.vtm", "discontinuities.vtpc", "illumination.vtm",
      "illumination.vtpc"};
  if (std::ranges::count(roots, std::string_view(relative.native())) > 0) return true;
  const std::string ending = relative.extension().string();
  const bool is_leaf = ending == ".vtp" || ending == ".vtu" || ending == ".stl" || ending == ".vtm";
  return is_leaf && relative.has_parent_path() && is_leaf_folder(relative.begin()->string());
}

}  // namespace gnomon::viz
