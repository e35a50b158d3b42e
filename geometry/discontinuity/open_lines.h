#pragma once

/// Which lines of sight along an arc may come through. Private to this folder.

#include <array>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/ruled_lines.h"

namespace gnomon::event {

/// A closed range of a parameter, which is told exactly.
struct NearRange {
  double from = 0;
  double to = 1;
};

/// The parts of an arc whose lines of sight may reach the light between the three edges' ends and come through.
///
/// Left out: parts all of whose points lie outside of some boxes; whose lines miss one of the edges, or the light, or
///           meet one of the edges not between the point and the light; whose lines pass strictly through one blocker:
///           beside such a line nothing is seen of the light, so no gap closes there; about which the three edges
///           leave a direction open.
/// Method:   by intervals, halving where these do not tell.
class OpenLines {
 public:
  /// Requires: the rounding mode is protected while it lives.
  OpenLines(const EventScene& scene, std::span<const ShapeId> shapes, const ReceiverPlane& plane,
            std::vector<FlatEnclosure> boxes);

  /// Of three edges no two of which lie in one plane, as shares of the first of them.
  std::vector<NearRange> ranges(const std::array<const SilhouetteEdge*, 3>& edges) const;
  /// Of the last two of three edges where they cross, along a straight line; see RuledLines.
  std::vector<NearRange> ranges(const std::array<const SilhouetteEdge*, 3>& edges, const SilhouetteEdge& parting,
                                const conic::FlatCurve& line, const NearRange& range) const;

 private:
  class Question;

  /// A corner loop in its plane, by its lines, each with the sign of the way in which it runs.
  struct Facet {
    NearPlane plane;
    std::vector<std::pair<std::uint32_t, int>> lines;
  };
  struct NearShape {
    ShapeId shape = 0;
    std::vector<NearLine> lines;
    std::vector<Facet> facets;
  };

  PointEnclosure point(PointId id) const;
  NearShape near_shape(ShapeId shape) const;

  const EventScene& scene_;
  NearFrame frame_;
  std::vector<FlatEnclosure> boxes_;
  NearPlane light_plane_;              ///< of an area light
  std::vector<NearLine> light_lines_;  ///< between its corners
  std::vector<NearShape> shapes_;
};

}  // namespace gnomon::event
