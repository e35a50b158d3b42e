#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

#include "gnomon/point.h"

namespace gnomon::viz {

/// The points as doubles, which is not what VTK does by itself.
inline vtkSmartPointer<vtkPoints> vtk_points(std::span<const Point3> points) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  for (const Point3& p : points) result->InsertNextPoint(p.x, p.y, p.z);
  return result;
}

/// Adds one cell whose points have the given numbers, each grown by `offset`.
template <class Indices>
void insert_cell(vtkCellArray& cells, const Indices& indices, vtkIdType offset = 0) {
  std::vector<vtkIdType> ids;
  for (const auto index : indices) ids.push_back(offset + static_cast<vtkIdType>(index));
  cells.InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

}  // namespace gnomon::viz
