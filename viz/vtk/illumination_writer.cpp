#include "viz/vtk/illumination_writer.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "gnomon/errors.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/tree_result.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon {
namespace {

template <class Array>
Array& added(vtkFieldData& to, const std::string& name, int components = 1) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  to.AddArray(array);
  return *array;
}

void add_point_values(vtkPointSet& data, const IlluminatedSide& side, const std::vector<std::string>& lights) {
  vtkFieldData& to = *data.GetPointData();
  auto &sum = added<vtkDoubleArray>(to, "irradiance"), &bound = added<vtkDoubleArray>(to, "irradiance_bound");
  for (const IlluminationMesh* mesh : side.pieces) {
    for (const Irradiance& e : mesh->irradiance) {
      sum.InsertNextValue(e.value);
      bound.InsertNextValue(e.error_bound);
    }
  }
  for (std::size_t l = 0; l < lights.size(); ++l) {
    auto& array = added<vtkDoubleArray>(to, "irradiance_" + lights[l]);
    for (const IlluminationMesh* mesh : side.pieces) {
      for (const Irradiance& e : mesh->of_lights[l]) array.InsertNextValue(e.value);
    }
  }
  if (!side.diffuse) return;
  auto& radiosity = added<vtkDoubleArray>(to, "radiosity_direct", 3);
  for (const IlluminationMesh* mesh : side.pieces) {
    for (const Irradiance& e : mesh->irradiance) {
      for (const double share : *side.diffuse) radiosity.InsertNextValue(share * e.value);
    }
  }
}

void add_face_values(vtkPointSet& data, const IlluminatedSide& side) {
  vtkFieldData& to = *data.GetCellData();
  auto& error = added<vtkDoubleArray>(to, "error");
  auto& unmet = added<vtkUnsignedCharArray>(to, "unmet");
  auto& id = added<vtkIntArray>(to, "face_id");
  int next = 0;
  for (const IlluminationMesh* mesh : side.pieces) {
    for (const IlluminationFace& face : mesh->faces) {
      error.InsertNextValue(face.error);
      unmet.InsertNextValue(face.is_met ? 0 : 1);
      id.InsertNextValue(next++);
    }
  }
}

vtkSmartPointer<vtkPoints> points_of(const IlluminatedSide& side) {
  std::vector<Point3> all;
  for (const IlluminationMesh* mesh : side.pieces) all.insert(all.end(), mesh->points.begin(), mesh->points.end());
  return viz::vtk_points(all);
}

vtkSmartPointer<vtkPointSet> faces_of(const IlluminatedSide& side, int order) {
  vtkNew<vtkCellArray> cells;
  vtkIdType first = 0;
  for (const IlluminationMesh* mesh : side.pieces) {
    for (const IlluminationFace& face : mesh->faces) {
      std::vector<std::uint32_t> nodes(face.corners.begin(), face.corners.end());
      if (order == 2) nodes.insert(nodes.end(), face.middles.begin(), face.middles.end());
      viz::insert_cell(*cells, nodes, first);
    }
    first += static_cast<vtkIdType>(mesh->points.size());
  }
  if (order == 1) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_of(side));
    data->SetPolys(cells);
    return data;
  }
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  data->SetPoints(points_of(side));
  data->SetCells(VTK_QUADRATIC_TRIANGLE, cells);
  return data;
}

vtkSmartPointer<vtkPointSet> edges_of(const IlluminatedSide& side) {
  vtkNew<vtkCellArray> cells;
  std::vector<viz::CellName> names;
  vtkIdType first = 0;
  for (const IlluminationMesh* mesh : side.pieces) {
    for (const IlluminationEdge& edge : mesh->edges) {
      viz::insert_cell(*cells, edge.ends, first);
      names.emplace_back();
      names.back().discontinuity_order = edge.order;
    }
    first += static_cast<vtkIdType>(mesh->points.size());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_of(side));
  data->SetLines(cells);
  viz::add_cell_arrays(*data, names);
  return data;
}

std::vector<viz::Block> illumination_blocks(const IlluminationResult& result, const ShadowResult& frame) {
  std::vector<viz::Block> blocks;
  viz::append_scene_blocks(blocks, frame);
  for (const IlluminatedSide& side : result.sides) {
    viz::Fields fields = viz::leaf_fields(frame, false);
    fields.push_back({"receiver", std::vector<std::string>{side.name}});
    fields.push_back({"tolerance", std::vector<double>{result.tolerance}});
    const auto faces = faces_of(side, result.order);
    add_point_values(*faces, side, result.lights);
    add_face_values(*faces, side);
    viz::append_block(blocks, {{"illumination", side.name}, "illumination", fields, faces});
    viz::append_block(blocks, {{"illumination_edges", side.name}, "illumination_edges", fields, edges_of(side)});
  }
  return blocks;
}

}  // namespace

std::vector<std::filesystem::path> write_illumination(const IlluminationResult& result,
                                                      const std::filesystem::path& directory,
                                                      const std::vector<OutputFormat>& formats) {
  if (result.scene == nullptr) throw PreconditionError("write_illumination: a result without a scene");
  const ShadowResult frame{result.scene, result.clip_box, {}};
  const std::vector<viz::Block> blocks = illumination_blocks(result, frame);
  return viz::write_tree(blocks, frame, "illumination", directory, formats);
}

}  // namespace gnomon
