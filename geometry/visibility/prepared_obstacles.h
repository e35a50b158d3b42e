#pragma once

#include <variant>
#include <vector>

#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/fast_point_visibility.h"
#include "geometry/visibility/fast_visibility.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// True if the point lies strictly inside an enclosure. Of a receiver's point: and none of the enclosure's triangles
/// lies in the receiver's plane, and it rests on none.
bool is_enclosed(const Obstacles& obstacles, const Point3& p);
bool is_enclosed(const Obstacles& obstacles, const ReceiverPoint& receiver);

struct PreparedObstacles::Content {
  explicit Content(Obstacles given);

  /// True if the point is enclosed: see is_enclosed. Where it lies in the box around no enclosure this is quick.
  template <class Looking>
  bool encloses(const Looking& p) const {
    return may_enclose(place_of(p)) && is_enclosed(obstacles, p);
  }

  Obstacles obstacles;
  BlockerSet blockers;

 private:
  static const Point3& place_of(const Point3& p) { return p; }
  static const Point3& place_of(const ReceiverPoint& receiver) { return receiver.point; }
  bool may_enclose(const Point3& p) const;

  std::vector<Box3> enclosures_;
};

/// The fast level for any light.
using FastLevel = std::variant<FastPointVisibility, FastLinearVisibility, FastVisibility>;

FastLevel fast_level(const Light& light, const BlockerSet& blockers);

}  // namespace gnomon
