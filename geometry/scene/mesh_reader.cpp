#include "geometry/scene/mesh_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/scene/file_text.h"
#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_convexity.h"
#include "geometry/scene/mesh_facets.h"
#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/mesh_text.h"
#include "geometry/scene/written_mesh.h"

namespace gnomon {
namespace {

constexpr std::size_t largest_mesh_file = std::size_t{128} << 20;
constexpr std::size_t largest_material_file = std::size_t{1} << 20;

/// The file name, if it stays in the scene's folder.
std::filesystem::path checked_path(const JsonNode& node, const std::string& file) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (file.empty() || std::any_of(file.begin(), file.end(), is_control)) node.refuse_value("the name of a mesh file");
  std::filesystem::path path(file);
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
    node.refuse_value("a file beside the scene: no absolute path, no \"..\"");
  }
  return path;
}

using SoupReader = PolygonSoup (*)(std::string_view, const MeshSource&);

SoupReader soup_reader(const JsonNode& node, const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".obj") return obj_soup;
  if (extension == ".off") return off_soup;
  if (extension == ".ply") return ply_soup;
  if (extension == ".stl") return stl_soup;
  node.refuse_value("a mesh file that ends in .obj, .off, .ply or .stl");
}

/// Makes equal vertices one, and leaves out those that are in no facet.
void merge_vertices(PolygonSoup& soup) {
  const auto less = [](const Point3& p, const Point3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
  std::vector<bool> is_used(soup.vertices.size(), false);
  for (const auto& facet : soup.facets) {
    for (const std::uint32_t index : facet) is_used[index] = true;
  }
  std::map<Point3, std::uint32_t, decltype(less)> known(less);
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> renumbered(soup.vertices.size());
  for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
    if (!is_used[i]) continue;
    const auto [entry, is_new] = known.try_emplace(soup.vertices[i], static_cast<std::uint32_t>(vertices.size()));
    if (is_new) vertices.push_back(soup.vertices[i]);
    renumbered[i] = entry->second;
  }
  soup.vertices = std::move(vertices);
  for (auto& facet : soup.facets) {
    for (std::uint32_t& index : facet) index = renumbered[index];
  }
}

/// Every directed edge once, and its opposite too. Facets without an area count: they close gaps between others.
bool is_closed(const PolygonSoup& soup) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& all_corners : soup.facets) {
    const Ring facet = without_repeats(soup.vertices, all_corners);
    if (facet.size() < 3) continue;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      if (!edges.emplace(facet[i], facet[i + 1 == facet.size() ? 0 : i + 1]).second) return false;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return edges.contains({e.second, e.first}); });
}

/// Lamps of other programs, which count as blockers here. Material files that are not there are not missed.
void doubt_emission(const PolygonSoup& soup, const std::filesystem::path& folder, std::vector<std::string>& doubts) {
  for (const std::string& file : soup.material_files) {
    const std::filesystem::path path(file);
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) continue;
    const FileText text = file_text(folder / path, largest_material_file);
    if (!text.problem.empty()) continue;
    const std::set<std::string> emitting = emitting_materials(text.text);
    for (const std::string& material : soup.materials) {
      if (!emitting.contains(material)) continue;
      doubts.push_back("the facets of the material " + word_text(material) + " emit light (Ke in " + word_text(file) +
                       "), but count as blockers, not as lights");
    }
  }
}

/// Leaves the facets of one of an OBJ file's materials, "" being those before any `usemtl`.
void keep_material(PolygonSoup& soup, const JsonNode& node) {
  const std::string wanted = node.string("the name of a material in the OBJ file");
  const auto known = std::ranges::find(soup.materials, wanted);
  if (known == soup.materials.end()) {
    std::string all;
    for (const std::string& material : soup.materials) all += (all.empty() ? "" : ", ") + word_text(material);
    node.refuse(word_text(wanted), all.empty() ? "no such key: the file has no materials" : "one of " + all);
  }
  const auto number = static_cast<std::uint32_t>(known - soup.materials.begin());
  PolygonSoup kept;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    if (soup.facet_materials[f] != number) continue;
    kept.facets.push_back(std::move(soup.facets[f]));
    kept.lines.push_back(soup.lines[f]);
    kept.corner_normals.push_back(std::move(soup.corner_normals[f]));
  }
  soup.facets = std::move(kept.facets);
  soup.lines = std::move(kept.lines);
  soup.corner_normals = std::move(kept.corner_normals);
  soup.materials = {wanted};
  soup.facet_materials.assign(soup.facets.size(), 0);
}

PolygonSoup soup_of(const JsonNode& node, const std::optional<JsonNode>& material, const MeshSource& source,
                    const std::filesystem::path& folder) {
  const std::filesystem::path path = checked_path(node, source.file);
  const SoupReader reader = soup_reader(node, path);
  const FileText text = file_text(folder / path, largest_mesh_file, FileKind::regular);
  if (!text.problem.empty()) source.refuse("beside the scene", text.problem, "a mesh file");
  PolygonSoup soup = reader(text.text, source);
  if (material) keep_material(soup, *material);
  doubt_emission(soup, (folder / path).parent_path(), soup.doubts);
  merge_vertices(soup);
  return soup;
}

bool is_written_mesh(const SceneElement& element) {
  return element.node.optional("vertices") || element.node.optional("facets");
}

/// The mesh that stands in the scene itself. What is said of files has nothing to go with.
PolygonSoup written_mesh(const SceneElement& element) {
  for (const char* key : {"file", "usemtl"}) {
    if (const auto node = element.node.optional(key)) node->refuse_value("no such key beside \"facets\"");
  }
  const auto normals = element.node.optional("normals");
  if (normals && normals->description() == "the string \"file\"") {
    normals->refuse_value("other normals, as the mesh is no file");
  }
  PolygonSoup soup = written_soup(element);
  merge_vertices(soup);
  return soup;
}

void add_doubts(const std::string& title, std::vector<std::string> found, std::vector<std::string>& doubts) {
  for (std::string& doubt : found) {
    std::string sentence = title + ": " + doubt;
    if (!doubt.empty() && std::ranges::find(doubts, sentence) == doubts.end()) doubts.push_back(std::move(sentence));
  }
}

/// The file's normals at the corners of facets, by their vertices.
///
/// Throws: SceneError where a corner has none.
std::vector<std::vector<Point3>> file_normals(const PolygonSoup& soup, const CheckedFacets& checked,
                                              const JsonNode& normals, const std::string& file) {
  std::vector<std::vector<Point3>> result;
  for (std::size_t f = 0; f < checked.facets.size(); ++f) {
    const std::size_t in_file = checked.numbers[f];
    std::vector<Point3> corners;
    for (const std::uint32_t vertex : checked.facets[f]) {
      const auto& all = soup.facets[in_file];
      const auto at = static_cast<std::size_t>(std::ranges::find(all, vertex) - all.begin());
      const bool has_normals = in_file < soup.corner_normals.size() && at < soup.corner_normals[in_file].size();
      const std::size_t n = has_normals ? soup.corner_normals[in_file][at] : soup.normals.size();
      if (n >= soup.normals.size()) {
        normals.refuse(
            "\"file\", but in " + word_text(file) + " a corner without a normal: " + facet_place(soup, in_file),
            "an OBJ file with a normal at every corner (f v//vn), or other normals");
      }
      corners.push_back(soup.normals[n]);
    }
    result.push_back(std::move(corners));
  }
  return result;
}

/// Zero normals leave their facets flat.
std::string zero_normals_doubt(const std::vector<std::vector<Point3>>& normals) {
  const auto count = std::ranges::count_if(normals, [](const std::vector<Point3>& corners) {
    return std::ranges::find(corners, Point3{}) != corners.end();
  });
  if (count == 0) return {};
  return "normals of the file are zero or no vectors at corners of " + std::to_string(count) +
         (count == 1 ? " facet, which is shaded flat" : " facets, which are shaded flat");
}

}  // namespace

Mesh read_mesh(const SceneElement& element, const std::filesystem::path& folder, SpaceScene& scene, MeshUse use) {
  const bool is_written = is_written_mesh(element);
  const JsonNode node = is_written ? element.node.required("facets", "an array of facets")
                                   : element.node.required("file", "the name of a mesh file");
  const MeshSource source{node, is_written ? "" : node.string("the name of a mesh file")};
  PolygonSoup soup =
      is_written ? written_mesh(element) : soup_of(node, element.node.optional("usemtl"), source, folder);
  CheckedFacets checked = checked_facets(soup, source, scene.length_unit);
  if (checked.facets.empty()) source.refuse("the whole file", "no facet with an area", "at least one");
  add_doubts(element.title + ": in " + word_text(source.file), std::move(soup.doubts), scene.doubts);
  add_doubts(element.title, std::move(checked.doubts), scene.doubts);
  const bool closed = is_closed(soup);
  if (!closed && use == MeshUse::blocker) {
    scene.doubts.push_back(element.title +
                           ": the mesh is not closed, or its facets are not all wound the same way; they count as "
                           "single blockers, not as the surface of a solid");
  }
  std::vector<std::vector<Point3>> corner_normals;
  if (const auto key = element.node.optional("normals"); key && key->description() == "the string \"file\"") {
    corner_normals = file_normals(soup, checked, *key, source.file);
    add_doubts(element.title, {zero_normals_doubt(corner_normals)}, scene.doubts);
  }
  if (checked.facets.size() == soup.facets.size()) checked.numbers.clear();
  std::optional<double> dents;
  if (closed && use != MeshUse::receiver) dents = deviation_from_convex(soup.vertices, checked.facets);
  if (use == MeshUse::light && !dents) {
    node.refuse_as_unsupported(
        closed ? "a mesh that is not convex" : "a mesh that is not closed",
        "a light that is a closed convex mesh, or a polygon: others are not available in this version");
  }
  if (dents && *dents > 0 && use == MeshUse::blocker) {
    scene.doubts.push_back(element.title + ": it is a convex solid but for dents of up to " + shortest(*dents) + " " +
                           scene.length_unit +
                           ", within the limit of 1e-9 of its diameter; its volumes are those of the hull of its "
                           "vertices");
  }
  return {source.file, std::move(soup.vertices), std::move(checked.facets), closed, std::move(checked.numbers),
          dents,       std::move(corner_normals)};
}

}  // namespace gnomon
