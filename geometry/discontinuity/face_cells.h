#pragma once

/// A receiver's face divided by the arcs on which the last gap of light closes. Private to this folder.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/conics/curve_map.h"
#include "geometry/discontinuity/closing_arcs.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::event {

/// An arc between two cells of different regions.
struct CellArc {
  std::uint32_t curve = 0;  ///< index into FaceCells::curves, as are those of nodes
  RealRoot from;
  RealRoot to;
  std::uint32_t start = 0;  ///< node
  std::uint32_t end = 0;
  std::vector<std::uint32_t> names;  ///< indices into ClosingArcs::names
};

/// An arc, or a part of one side of the face, as it is met with a cell on the left.
struct CellSide {
  bool is_arc = false;
  std::uint32_t index = 0;  ///< of the arc, or the side's name
  bool is_forward = true;   ///< as the arc's parameter grows; as the side runs
  std::uint32_t start = 0;  ///< node
  std::uint32_t end = 0;
  RealRoot at_start;  ///< of a side, on its line
  RealRoot at_end;
};

struct Cell {
  ReceiverRegion region = ReceiverRegion::umbra;
  std::vector<std::vector<CellSide>> cycles;
};

struct FaceCells {
  std::vector<conic::FlatCurve> curves;
  std::vector<conic::CurveMap::Node> nodes;
  std::vector<CellArc> arcs;
  std::vector<Cell> cells;  ///< no two of one region have a common arc

  bool is_divided() const { return cells.size() > 1; }
};

/// Requires: arcs that are told apart; a function that tells the region of a point that lies on no arc.
FaceCells face_cells(const conic::CurveMap& map, std::span<const conic::Side> sides,
                     const std::function<ReceiverRegion(const FlatPoint&)>& region_of);

}  // namespace gnomon::event
