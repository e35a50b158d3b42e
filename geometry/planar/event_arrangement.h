#pragma once

/// The arrangement of all event rays, blockers and what else may bound a face. Heavy: for few .cpp files.

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <optional>
#include <vector>

#include "geometry/planar/viewpoint.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::planar {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Of curves that overlap, the common part bears the lowest number.
struct LowerNumber {
  std::uint32_t operator()(std::uint32_t a, std::uint32_t b) const { return a < b ? a : b; }
};

using SegmentTraits = CGAL::Arr_segment_traits_2<ExactKernel>;
using NumberedTraits = CGAL::Arr_curve_data_traits_2<SegmentTraits, std::uint32_t, LowerNumber, std::uint32_t>;
/// Vertices and halfedges bear a number, faces the number of what they are merged into.
using NumberedDcel = CGAL::Arr_extended_dcel<NumberedTraits, std::uint32_t, std::uint32_t, std::uint32_t>;
using EventArrangement = CGAL::Arrangement_2<NumberedTraits, NumberedDcel>;

/// The arrangement; the number of a curve is the place of its name in `names`. Blockers come first, the box last.
///
/// Returns: what is unbounded is cut by a square frame so large that lines which meet meet strictly inside it; the
///          frame's number is names.size(). Beyond it nothing happens any more.
void build_arrangement(const Flatland& flatland, const PartitionOptions& options, EventArrangement& arrangement,
                       std::vector<BoundaryName>& names);

/// A point inside a bounded face.
ExactKernel::Point_2 inner_point(EventArrangement::Face_const_handle face);

/// A point inside an edge.
ExactKernel::Point_2 inner_point(EventArrangement::Halfedge_const_handle edge);

/// The point to look from; evaluated exactly only if its interval does not tell.
Viewpoint viewpoint(const ExactKernel::Point_2& point);

ExactPoint exact(const ExactKernel::Point_2& point);

}  // namespace gnomon::planar
