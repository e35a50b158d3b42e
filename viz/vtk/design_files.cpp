#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <numbers>

#include "gnomon/writer.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/field_data.h"
#include "viz/vtk/file_name.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/tree_file.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon {
namespace {

/// The files of one design, as they come into being.
class DesignFolder {
 public:
  DesignFolder(const std::filesystem::path& directory, viz::Fields fields)
      : folder_(directory), fields_(std::move(fields)) {}

  void add(const std::string& name, const std::vector<std::string>& path, vtkPointSet& data) {
    if (data.GetNumberOfPoints() == 0) return;
    viz::add_field_data(*data.GetFieldData(), fields_);
    viz::write_data(data, folder_.add(name));
    leaves_.push_back({path, name});
  }

  std::vector<std::filesystem::path> publish() {
    folder_.add_text("design.vtm", viz::multiblock_xml(leaves_, fields_));
    folder_.publish();
    return {folder_.directory() / "design.vtm"};
  }

 private:
  viz::StagedFolder folder_;
  viz::Fields fields_;
  std::vector<viz::TreeLeaf> leaves_;
};

vtkSmartPointer<vtkIntArray> added_numbers(vtkCellData& data, const char* name) {
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  data.AddArray(array);
  return array;
}

int cell_type(const DrawnCell& cell) {
  if (cell.walls.size() > 1) return VTK_CONVEX_POINT_SET;
  if (cell.walls.size() == 1) return VTK_POLYGON;
  return cell.corners.size() > 1 ? VTK_LINE : VTK_VERTEX;
}

vtkSmartPointer<vtkUnstructuredGrid> solid_cells(const std::vector<DrawnCell>& cells) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto ids = added_numbers(*grid->GetCellData(), "cell_id");
  for (std::size_t c = 0; c < cells.size(); ++c) {
    std::vector<vtkIdType> corners;
    for (const Point3& p : cells[c].corners) corners.push_back(points->InsertNextPoint(p.x, p.y, p.z));
    const int type = cell_type(cells[c]);
    if (type == VTK_POLYGON) {
      const vtkIdType first = corners.front();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        corners[k] = first + static_cast<vtkIdType>(cells[c].walls[0].corners[k]);
      }
    }
    grid->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
    ids->InsertNextValue(static_cast<int>(c));
  }
  grid->SetPoints(points);
  return grid;
}

vtkSmartPointer<vtkPolyData> wall_polygons(const std::vector<DrawnCell>& cells) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  vtkCellData& arrays = *data->GetCellData();
  const auto kinds = added_numbers(arrays, "facet_kind"), goals = added_numbers(arrays, "goal_id"),
             edges = added_numbers(arrays, "edge_index"), vertices = added_numbers(arrays, "vertex_index");
  for (const DrawnCell& cell : cells) {
    if (cell.walls.empty()) continue;
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Point3& p : cell.corners) points->InsertNextPoint(p.x, p.y, p.z);
    for (const DrawnWall& wall : cell.walls) {
      viz::insert_cell(*polygons, wall.corners, first);
      kinds->InsertNextValue(wall.facet_kind);
      goals->InsertNextValue(wall.goal);
      edges->InsertNextValue(wall.edge);
      vertices->InsertNextValue(wall.vertex);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

/// A point as a vertex, a polygon as one.
vtkSmartPointer<vtkPolyData> subject_shapes(const DrawnGoal& goal) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices, polygons;
  const auto status = added_numbers(*data->GetCellData(), "goal_status");
  for (const std::vector<Point3>& subject : goal.subjects) {
    vtkCellArray& cells = subject.size() == 1 ? *vertices : *polygons;
    cells.InsertNextCell(static_cast<int>(subject.size()));
    for (const Point3& p : subject) cells.InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    status->InsertNextValue(goal.status);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetPolys(polygons);
  return data;
}

vtkSmartPointer<vtkPolyData> answer_point(const Point3& answer, double margin) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(viz::vtk_points({&answer, 1}));
  vtkNew<vtkCellArray> vertices;
  viz::insert_cell(*vertices, std::vector<int>{0});
  data->SetVerts(vertices);
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("margin");
  radius->InsertNextValue(margin);
  data->GetCellData()->AddArray(radius);
  return data;
}

/// A sphere, for the eye.
vtkSmartPointer<vtkPolyData> ball(const Point3& centre, double radius) {
  constexpr int around = 32, rings = 16;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (int i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (int j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * j / around;
      points->InsertNextPoint(centre.x + radius * std::sin(polar) * std::cos(turn),
                              centre.y + radius * std::sin(polar) * std::sin(turn),
                              centre.z + radius * std::cos(polar));
      const int next = (j + 1) % around;
      if (i < rings) {
        viz::insert_cell(*polygons, std::vector<int>{i * around + j, (i + 1) * around + j, (i + 1) * around + next,
                                                     i * around + next});
      }
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

}  // namespace

std::vector<std::filesystem::path> write_design(const DrawnDesign& design, const Scene& scene,
                                                const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const DrawnGoal& goal : design.goals) names.push_back(goal.name);
  DesignFolder folder(directory, {{"producer", std::vector<std::string>{"gnomon"}},
                                  {"version", std::vector<std::string>{GNOMON_VERSION}},
                                  {"scene", std::vector<std::string>{facts(scene).source}},
                                  {"length_unit", std::vector<std::string>{facts(scene).length_unit}},
                                  {"status", std::vector<std::string>{design.status}},
                                  {"goal_names", names}});
  folder.add("design/feasible/cells.vtu", {"design", "feasible", "cells"}, *solid_cells(design.cells));
  folder.add("design/feasible/surface.vtp", {"design", "feasible", "surface"}, *wall_polygons(design.cells));
  for (const DrawnGoal& goal : design.goals) {
    folder.add("design/goals/" + viz::file_name(goal.name) + ".vtp", {"design", "goals", goal.name},
               *subject_shapes(goal));
  }
  if (design.answer) {
    folder.add("design/answer.vtp", {"design", "answer"}, *answer_point(*design.answer, design.margin));
    if (design.margin > 0) folder.add("design/ball.vtp", {"design", "ball"}, *ball(*design.answer, design.margin));
  }
  return folder.publish();
}

}  // namespace gnomon
