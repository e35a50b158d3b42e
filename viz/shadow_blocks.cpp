#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <numeric>

#include "geometry/region.h"
#include "viz/block.h"
#include "viz/cell_arrays.h"
#include "viz/receiver_blocks.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

/// What all cells of one volume have in common.
CellName volume_cell(const PairResult& pair, std::string_view volume) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(pair.light_id);
  cell.blocker_id = static_cast<std::int32_t>(pair.blocker_id);
  if (volume == "umbra" || volume == "umbra_pockets") {
    cell.region = static_cast<std::uint8_t>(Region::umbra);
    cell.visible_fraction = 0;
  } else if (volume == "penumbra") {
    cell.region = static_cast<std::uint8_t>(Region::penumbra);
  }
  return cell;
}

CellName with_facet(CellName cell, const FacetName& facet, std::size_t facet_id) {
  cell.facet_id = static_cast<std::int32_t>(facet_id);
  cell.facet_kind = static_cast<std::uint8_t>(facet.kind);
  cell.edge_index = facet.edge_index;
  cell.vertex_index = facet.vertex_index;
  return cell;
}

vtkSmartPointer<vtkPointSet> surface(const VolumeMesh& mesh, const CellName& common) {
  vtkNew<vtkCellArray> triangles;
  std::vector<CellName> names;
  for (const MeshTriangle& triangle : mesh.triangles) {
    insert_cell(*triangles, triangle.vertices);
    names.push_back(with_facet(common, mesh.facets[triangle.facet], triangle.facet));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(mesh.vertices));
  data->SetPolys(triangles);
  add_cell_arrays(*data, names);
  return data;
}

/// A polyhedron as VTK wants it: the number of faces, then each face with its number of points.
void insert_polyhedron(vtkUnstructuredGrid& grid, const VolumeCells::Cell& cell) {
  std::vector<vtkIdType> stream;
  for (const VolumeCells::Face& face : cell.faces) {
    stream.push_back(static_cast<vtkIdType>(face.size()));
    stream.insert(stream.end(), face.begin(), face.end());
  }
  grid.InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(cell.faces.size()), stream.data());
}

vtkSmartPointer<vtkPointSet> solid(const VolumeCells& cells, const CellName& common) {
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  data->SetPoints(vtk_points(cells.vertices));
  for (const VolumeCells::Cell& cell : cells.cells) insert_polyhedron(*data, cell);
  add_cell_arrays(*data, std::vector<CellName>(cells.cells.size(), common));
  return data;
}

vtkSmartPointer<vtkPointSet> plane_polygons(const std::vector<PlanePolygon>& planes, const CellName& common) {
  std::vector<Point3> points;
  vtkNew<vtkCellArray> polygons;
  std::vector<CellName> names;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].vertices.empty()) continue;
    std::vector<std::size_t> indices(planes[i].vertices.size());
    std::iota(indices.begin(), indices.end(), points.size());
    insert_cell(*polygons, indices);
    points.insert(points.end(), planes[i].vertices.begin(), planes[i].vertices.end());
    names.push_back(with_facet(common, planes[i].name, i));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetPolys(polygons);
  add_cell_arrays(*data, names);
  return data;
}

template <class Pair>
Fields volume_fields(const ShadowResult& result, const Pair& pair, const VolumeMesh& mesh) {
  Fields fields = pair_fields(result, pair.light, pair.blocker, mesh.truncated);
  fields.push_back({"volume_total", std::vector<double>{mesh.volume.nearest}});
  fields.push_back({"volume_exact", std::vector<std::string>{mesh.volume.exact}});
  return fields;
}

void append_volumes(std::vector<Block>& blocks, const ShadowResult& result, const PairResult& pair) {
  const auto append = [&](const std::string& name, const VolumeMesh& mesh) {
    append_block(blocks, {{"volumes", pair.light, pair.blocker, name},
                          "volume",
                          volume_fields(result, pair, mesh),
                          surface(mesh, volume_cell(pair, name))});
  };
  append("occlusion", pair.meshes.occlusion);
  append("umbra", pair.meshes.umbra);
  append("penumbra", pair.meshes.penumbra);
  if (pair.is_solid) append("umbra_pockets", pair.meshes.umbra_pockets);
}

/// For every `facet_id` the field `facet_part` has the number of the part that the facet comes from.
void append_merged(std::vector<Block>& blocks, const ShadowResult& result, const MergedResult& merged) {
  CellName common;
  common.light_id = static_cast<std::int32_t>(merged.light_id);
  common.blocker_id = static_cast<std::int32_t>(merged.blocker_id);
  const VolumeMesh& mesh = merged.occlusion.mesh;
  Fields fields = volume_fields(result, merged, mesh);
  const auto& parts = merged.occlusion.facet_part;
  fields.push_back({"facet_part", std::vector<std::int32_t>(parts.begin(), parts.end())});
  append_block(blocks, {{"volumes", merged.light, merged.blocker, "occlusion_merged"},
                        "volume",
                        std::move(fields),
                        surface(mesh, common)});
}

void append_solids(std::vector<Block>& blocks, const ShadowResult& result, const PairResult& pair) {
  const auto append = [&](const std::string& name, const VolumeMesh& mesh, const VolumeCells& cells) {
    append_block(blocks, {{"solids", pair.light, pair.blocker, name},
                          "solid",
                          volume_fields(result, pair, mesh),
                          solid(cells, volume_cell(pair, name))});
  };
  append("umbra", pair.meshes.umbra, pair.meshes.umbra_cells);
  append("penumbra", pair.meshes.penumbra, pair.meshes.penumbra_cells);
}

void append_planes(std::vector<Block>& blocks, const ShadowResult& result, const PairResult& pair) {
  append_block(blocks, {{"extremal_planes", pair.light, pair.blocker},
                        "extremal_planes",
                        pair_fields(result, pair.light, pair.blocker, true),
                        plane_polygons(pair.meshes.extremal_planes, volume_cell(pair, ""))});
}

}  // namespace

std::vector<Block> shadow_blocks(const ShadowResult& result) {
  if (result.scene->dimension == 2) return planar_shadow_blocks(result);
  std::vector<const PairResult*> pairs;
  for (const PairResult& pair : result.pairs) {
    if (pair.supported) pairs.push_back(&pair);
  }
  // Blocks of one light are siblings, in whatever order the pairs come.
  std::ranges::stable_sort(pairs, {}, &PairResult::light_id);

  std::vector<Block> blocks;
  append_scene_blocks(blocks, result);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    append_volumes(blocks, result, *pairs[i]);
    if (i + 1 < pairs.size() && pairs[i + 1]->light_id == pairs[i]->light_id) continue;
    for (const MergedResult& merged : result.merged) {
      if (merged.light_id == pairs[i]->light_id) append_merged(blocks, result, merged);
    }
  }
  for (const auto append : {append_solids, append_planes}) {
    for (const PairResult* pair : pairs) append(blocks, result, *pair);
  }
  for (const SideResult side : sides_of(result.receivers)) append_receiver_faces(blocks, result, side);
  return blocks;
}

}  // namespace gnomon::viz
