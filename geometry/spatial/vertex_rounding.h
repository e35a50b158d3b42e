#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "geometry/spatial/double_double_plane.h"
#include "geometry/spatial/exact_space.h"

namespace gnomon {

/// The exact coordinates of a point of the space. It may be called in any rounding mode.
ExactVector exact_coordinates(const ExactSpace& space, VertexId vertex);

/// Rounds the points of a space.
///
/// Exactness: every coordinate is the double nearest to the exact one. Double words with an error bound decide almost
///            always; where they do not, exact numbers do.
/// Requires:  rounding to nearest while it is used.
class VertexRounding {
 public:
  explicit VertexRounding(const ExactSpace& space) : space_(space), planes_(space.plane_count()) {}

  Point3 operator()(VertexId vertex);

 private:
  const DoubleDoublePlane& double_double(PlaneId plane);

  const ExactSpace& space_;
  std::vector<std::optional<DoubleDoublePlane>> planes_;
};

}  // namespace gnomon
