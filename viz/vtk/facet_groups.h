#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "viz/vtk/palette.h"

namespace gnomon::viz {

/// The faces of a surface that lie in one region.
struct RegionFacets {
  int region;  ///< its number in the array
  std::string name;
  Color color;
  vtkSmartPointer<vtkPolyData> data;
};

/// The faces or lines across which the same derivative of the visible fraction jumps.
struct OrderedFacets {
  std::string name;  ///< "D0", "D1" or "D2"
  Color color;
  vtkSmartPointer<vtkPolyData> data;
};

/// The faces by their cell array `region`: lit, penumbra, umbra, unlit, unresolved_eee; others are left out.
std::vector<RegionFacets> region_facets(vtkPolyData& surface);

/// The faces by their cell array `discontinuity_order`, 0, 1 or 2; others are left out.
std::vector<OrderedFacets> ordered_surfaces(vtkPolyData& surface);

/// The lines by the same array.
std::vector<OrderedFacets> ordered_lines(vtkPolyData& surface);

}  // namespace gnomon::viz
