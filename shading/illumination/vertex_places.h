#pragma once

/// Exact places of a divided receiver's vertices. Private to the libraries.

#include <cstdint>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::illumination {

/// Where the vertices of a division lie, so that straight edges stay straight.
///
/// Vertices are exact but where an arc ends at a place that is not rational. Such a place is known to 2^-100; where it
/// is on a straight edge the point of the edge's line that is next to what is known is taken.
class VertexPlaces {
 public:
  /// The mesh outlives this.
  explicit VertexPlaces(const ReceiverMesh& mesh);

  ExactVector at(std::uint32_t vertex) const;

 private:
  std::uint32_t end_beyond(std::uint32_t from, std::uint32_t to) const;
  ExactVector known(std::uint32_t vertex) const;

  const ReceiverMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> along_;  ///< of a vertex that is not rational, those at its straight edges
};

}  // namespace gnomon::illumination
