#pragma once

/// Which lines of sight along an arc may come through. Private to this folder.

#include <array>
#include <span>
#include <vector>

#include "geometry/conics/near_curve.h"
#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/outline.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// An arc and the three edges that its points see in line, the first one, the base, at the share that the pencil tells.
struct ArcOfLines {
  conic::FlatArc arc;
  conic::LinePencil share;
  std::array<const Outline*, 3> edges{};
};

/// The parts of an arc whose lines of sight may reach the light between the three edges' ends and come through.
///
/// Left out: parts all of whose points lie outside of some boxes; or whose lines miss the light; or meet one of the
/// edges
///           not between the point and the light; or pass strictly through one blocker: beside such a line nothing is
///           seen of the light, so no gap closes there; or about which the three edges leave a direction open.
/// Method:   by intervals, halving.
class OpenLines {
 public:
  /// Requires: the rounding mode is protected while it lives.
  OpenLines(const EventScene& scene, std::span<const ShapeId> shapes, const ReceiverPlane& plane,
            std::vector<FlatEnclosure> boxes);

  std::vector<conic::Range> ranges(const ArcOfLines& arc);

 private:
  struct NearArc;
  enum class Known : std::uint8_t { closed, perhaps };

  void append(const ArcOfLines& arc, const NearArc& near, const conic::Range& range, int halvings,
              std::vector<ShapeId> shapes, std::vector<conic::Range>& found);
  Known lines(const ArcOfLines& arc, const NearArc& near, const conic::Range& range, std::vector<ShapeId>& shapes);
  bool miss_light(const PointEnclosure& p, const PointEnclosure& q) const;
  static bool leave_open(const ArcOfLines& arc, const PointEnclosure& p, const PointEnclosure& q);
  bool are_stopped(const PointEnclosure& p, const PointEnclosure& q, std::vector<ShapeId>& shapes);
  enum class Meeting : std::uint8_t { none, perhaps, all };
  Meeting meeting(const std::vector<PointId>& loop, const PointEnclosure& p, const PointEnclosure& q) const;
  Meeting meeting(ShapeId shape, const PointEnclosure& p, const PointEnclosure& q) const;

  const EventScene& scene_;
  std::vector<ShapeId> shapes_;  ///< those that stopped lines last come first
  const ReceiverPlane& plane_;
  std::vector<FlatEnclosure> boxes_;
  std::vector<PointEnclosure> points_;  ///< of the scene
};

}  // namespace gnomon::event
