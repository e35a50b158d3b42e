#pragma once

/// Receivers that are meshed together. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/convex_polygon.h"

namespace gnomon::illumination {

/// Groups of receivers in one plane, with one front, that hang together by whole edges: pieces of one wall. By the
/// lowest number; each ascending.
///
/// Exactness: edges are the same if their ends are the same points; one plane by signs of orientations.
std::vector<std::vector<std::uint32_t>> coplanar_groups(std::span<const ConvexPolygon> receivers);

}  // namespace gnomon::illumination
