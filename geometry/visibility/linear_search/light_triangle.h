#pragma once

/// What is asked of a search for blockers that may hide a linear light. Private to geometry/visibility.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/visibility/blocker_content.h"

namespace gnomon::viewpoint {

/// The triangle between a point and a linear light.
struct LightTriangle {
  std::array<Point3, 3> corners;  ///< the point, the light's start and end; not on one line
  LightPyramid pyramid;           ///< the same as half-spaces; the first two sides are the triangle's plane
};

/// What searches did, added up over questions. No machine changes these numbers.
struct SearchCounts {
  std::size_t candidates = 0;  ///< blockers found
  std::size_t tested = 0;      ///< blockers or voxels that were held against the triangle one by one
  std::size_t visited = 0;     ///< nodes of a hierarchy, or voxels that the triangle may meet
  std::size_t gathered = 0;    ///< entries of lists that were read
};

/// A way of finding blockers that may hide one linear light from points.
///
/// `find_candidates` replaces `found` by the indices of every blocker that has a point in the closed triangle, and some
/// others, in no order and perhaps more than once. `references` is how many entries are stored.
template <class Search>
concept LinearLightOccluders = requires(const Search& search, const LightTriangle& triangle,
                                        std::vector<std::uint32_t>& found, SearchCounts& counts) {
  search.find_candidates(triangle, found, counts);
  { search.references() } -> std::same_as<std::size_t>;
};

}  // namespace gnomon::viewpoint
