#include "geometry/scene/mesh_reader.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/scene/file_text.h"
#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/polygon_refusal.h"

namespace gnomon {
namespace {

constexpr std::size_t largest_mesh_file = std::size_t{128} << 20;

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

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

using SoupReader = PolygonSoup (*)(std::string_view, const MeshSource&);

SoupReader soup_reader(const JsonNode& node, const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".obj") return obj_soup;
  if (extension == ".off") return off_soup;
  if (extension == ".ply") return ply_soup;
  if (extension == ".stl") return stl_soup;
  node.refuse_value("a mesh file that ends in .obj, .off, .ply or .stl");
}

void merge_equal_vertices(PolygonSoup& soup) {
  const auto less = [](const Point3& p, const Point3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
  std::map<Point3, std::uint32_t, decltype(less)> known(less);
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> renumbered;
  for (const Point3& p : soup.vertices) {
    const auto [entry, is_new] = known.try_emplace(p, static_cast<std::uint32_t>(vertices.size()));
    if (is_new) vertices.push_back(p);
    renumbered.push_back(entry->second);
  }
  soup.vertices = std::move(vertices);
  for (auto& facet : soup.facets) {
    for (std::uint32_t& index : facet) index = renumbered[index];
  }
}

/// Every directed edge once, and its opposite too.
bool is_closed(const PolygonSoup& soup) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& facet : soup.facets) {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      if (!edges.emplace(facet[i], facet[i + 1 == facet.size() ? 0 : i + 1]).second) return false;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return edges.contains({e.second, e.first}); });
}

/// Returns the largest deviation of a facet from its plane.
double checked_facets(const PolygonSoup& soup, const MeshSource& source) {
  double largest = 0;
  std::vector<Point3> points;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    points.clear();
    for (const std::uint32_t index : soup.facets[f]) points.push_back(soup.vertices[index]);
    double deviation = 0;
    if (const auto refusal = simple_polygon_refusal(points, deviation)) {
      std::string place = "facet " + std::to_string(f);
      if (refusal->vertex) place += ", corner " + std::to_string(*refusal->vertex);
      source.refuse(place, refusal->found, refusal->expected);
    }
    largest = std::max(largest, deviation);
  }
  return largest;
}

}  // namespace

Mesh read_mesh(const SceneElement& element, const std::filesystem::path& folder, Scene& scene) {
  const JsonNode node = element.node.required("file", "the name of a mesh file");
  const std::string file = node.string("the name of a mesh file");
  const std::filesystem::path path = checked_path(node, file);
  const SoupReader reader = soup_reader(node, path);
  const FileText text = file_text(folder / path, largest_mesh_file);
  const MeshSource source{node, file};
  if (!text.problem.empty()) source.refuse("beside the scene", text.problem, "a mesh file");
  PolygonSoup soup = reader(text.text, source);
  if (soup.facets.empty()) source.refuse("the whole file", "no facet", "at least one");
  merge_equal_vertices(soup);
  const double deviation = checked_facets(soup, source);
  if (deviation > 0) {
    scene.doubts.push_back(element.title +
                           ": some facets are not exactly coplanar; their vertices deviate from a plane by up to " +
                           shortest(deviation) + " " + scene.length_unit + " and count as rounded");
  }
  const bool closed = is_closed(soup);
  if (!closed) {
    scene.doubts.push_back(element.title +
                           ": the mesh is not closed, or its facets are not all wound the same way; they count as "
                           "single blockers, not as the surface of a solid");
  }
  return {file, std::move(soup.vertices), std::move(soup.facets), closed};
}

}  // namespace gnomon
