#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/exact_number.h"
#include "geometry/planar/partition.h"

namespace gnomon::planar {

/// A triangle of a face. Orientation: counterclockwise; corners index PartitionInBox::points.
struct FaceTriangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t face = 0;
};

/// A face's area, and what rounding does not touch of it.
struct FaceInBox {
  Region region = Region::lit;
  ExactNumber area;
};

/// A partition of a box as it is drawn and written.
struct PartitionInBox {
  std::vector<Point2> points;           ///< the partition's vertices, each coordinate rounded once, to nearest
  std::vector<FaceTriangle> triangles;  ///< share whole sides with each other and with the edges; tile the box
  std::vector<FaceInBox> faces;
  std::array<ExactNumber, 3> areas;  ///< of lit, penumbra and umbra

  const ExactNumber& area(Region region) const { return areas[static_cast<std::size_t>(region)]; }
};

/// Triangulates the faces.
///
/// Requires:   partition.box(): a partition of a box.
/// Degenerate: two points may round to one; the triangles keep their corners.
/// Exactness:  triangulated and measured exactly; rounded at the end.
/// Throws:     PreconditionError.
PartitionInBox partition_in_box(const Partition& partition);

}  // namespace gnomon::planar
