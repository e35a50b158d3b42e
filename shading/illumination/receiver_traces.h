#pragma once

/// Where irradiance of one light on a receiver may jump or bend. Private to the libraries.

#include <cstdint>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::illumination {

/// The order of an edge along which nothing may jump.
inline constexpr std::uint8_t smooth = 3;

/// A segment on a receiver along which a derivative of the irradiance may jump.
struct Trace {
  ExactVector a;
  ExactVector b;
  std::uint8_t order = 2;  ///< the lowest derivative that may
};

/// What the division of a receiver by one light tells of it. Ends are exact, so that traces of several lights along one
/// line lie on one line; arcs are taken by their chords.
struct ReceiverTraces {
  std::vector<Trace> traces;   ///< along the border, too, where something touches it there
  std::vector<Point3> inside;  ///< one place of each triangle of the division's faces
};

ReceiverTraces traces_of(const ReceiverMesh& mesh);

/// The order of the lowest derivative that may jump across an edge; `smooth` if none does.
std::uint8_t order_of(const ReceiverMesh& mesh, const MeshEdge& edge);

}  // namespace gnomon::illumination
