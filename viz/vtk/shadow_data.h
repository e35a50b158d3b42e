#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "gnomon/result.h"
#include "viz/vtk/cell_arrays.h"

namespace gnomon::viz {

/// What all cells of one volume of a pair have in common; of other things of a pair `volume` is empty.
CellName volume_cell(const PairResult& pair, std::string_view volume);

/// Triangles and polygons of one pair, or of several that are put into one block, one after the other.
class ShadowSurface {
 public:
  /// Adds a volume's surface. The facets of later parts are numbered on. Where facets are of several blockers, these
  /// are given one by one.
  void add(const VolumeMesh& mesh, const CellName& common, std::span<const std::uint32_t> facet_blockers = {});

  /// Adds one polygon for every plane that the box does not miss.
  void add(const std::vector<PlanePolygon>& planes, const CellName& common);

  /// The cells added so far, with their arrays; `part_id` tells which call of `add` a cell is of, if there was more
  /// than one.
  vtkSmartPointer<vtkPointSet> data() const;

 private:
  std::vector<Point3> points_;
  vtkNew<vtkCellArray> polygons_;
  std::vector<CellName> names_;
  std::vector<std::int32_t> parts_;
  std::size_t facet_count_ = 0;
  std::int32_t part_count_ = 0;
};

/// Tetrahedra that fill volumes, likewise.
class ShadowSolid {
 public:
  void add(const VolumeCells& cells, const CellName& common);
  vtkSmartPointer<vtkPointSet> data() const;

 private:
  vtkNew<vtkCellArray> tetrahedra_;
  std::vector<Point3> points_;
  std::vector<CellName> names_;
  std::vector<std::int32_t> parts_;
  std::int32_t part_count_ = 0;
};

}  // namespace gnomon::viz
