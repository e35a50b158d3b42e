#pragma once

/// Exact places on a receiver whose mesh is known by rounded coordinates.

#include <array>
#include <optional>
#include <vector>

#include "apps/proof/laws/receiver_cases.h"
#include "apps/proof/laws/subject.h"
#include "apps/proof/laws/visibility_along_path.h"

namespace gnomon::laws {

/// A case in exact numbers.
struct ReceiverScene {
  explicit ReceiverScene(const ReceiverCase& one);

  const ReceiverCase& drawn;
  std::vector<Walls> blockers;
  ExactPlane floor;       ///< its positive side is the front
  Rational little;        ///< more than coordinates of the mesh are off by
  ExactVector direction;  ///< of the case, on the floor

  Path path(const ExactVector& start, const ExactVector& along) const { return {start, along, floor.normal}; }
  bool is_on_floor(const ExactVector& p) const;  ///< strictly inside its border
};

/// The loops of a blocker: itself if it is flat, else its facets.
std::vector<std::vector<ExactVector>> loops_of(const ConvexBlocker& blocker);

/// The edges of a blocker, each once.
std::vector<std::array<ExactVector, 2>> edges_of(const ConvexBlocker& blocker);

/// Where a blocker's outside stands on the floor or passes through it.
std::vector<std::array<ExactVector, 2>> contacts(const ReceiverScene& scene);

/// A point of a triangle of the mesh by its shares in the corners, which add up to 1; nothing if it could lie outside
/// of the triangle between the corners before they were rounded.
std::optional<ExactVector> place_in(const ReceiverScene& scene, const DividedReceiver& mesh,
                                    const ReceiverTriangle& triangle, const std::array<Rational, 3>& shares);

/// True if a point may lie on an edge of the mesh before its ends were rounded, and not far off it.
bool may_lie_on(const ReceiverScene& scene, const DividedReceiver& mesh, const MeshEdge& edge, const ExactVector& p);

/// The planes in which light and one blocker alone begin or end to hide: of a vertex of one and an edge of the other,
/// and of the blocker's walls.
std::vector<ExactPlane> event_planes(const ReceiverScene& scene);

/// True if some point between two sees three edges in line, each of the light or of a different blocker.
bool sees_three_edges_in_line(const ReceiverScene& scene, const ExactVector& from, const ExactVector& to);

}  // namespace gnomon::laws
