#pragma once

#include <cstdint>
#include <vector>

#include "geometry/numbers/orientation.h"
#include "geometry/spatial/pair_sides.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/pair.h"

namespace gnomon {

/// The corners of a light or blocker in the order in which the pair's algorithms walk them: a convex polygon forwards
/// or backwards, or the one or two points of a point or linear light.
/// Side k runs from corner k to corner k + 1; corner numbers are cyclic.
class Ring {
 public:
  Ring(const ConvexPolygon& polygon, bool reversed)
      : polygon_(&polygon),
        points_(polygon.points().data()),
        corners_(polygon.corners().data()),
        size_(static_cast<std::uint32_t>(polygon.corners().size())),
        reversed_(reversed) {}
  explicit Ring(const PointLight& light) : size_(1), loose_{light.position, light.position} {}
  explicit Ring(const LinearLight& light) : size_(2), loose_{light.start, light.end} {}

  std::uint32_t size() const { return size_; }
  std::uint32_t next(std::uint32_t k) const { return k + 1 == size_ ? 0 : k + 1; }
  std::uint32_t previous(std::uint32_t k) const { return k == 0 ? size_ - 1 : k - 1; }
  bool reversed() const { return reversed_; }

  const Point3& corner(std::uint32_t k) const { return polygon_ ? points_[corners_[forward_corner(k)]] : loose_[k]; }
  /// Index of corner k in the file's order.
  std::uint32_t corner_index(std::uint32_t k) const { return polygon_ ? corners_[forward_corner(k)] : k; }
  /// Index of the edge that names side k.
  std::uint32_t side_edge(std::uint32_t k) const { return polygon_ ? polygon_->side_edge(forward_side(k)) : 0; }
  /// Lowest index of the vertices on side k.
  std::uint32_t side_lowest_vertex(std::uint32_t k) const {
    return polygon_ ? polygon_->side_lowest_vertex(forward_side(k)) : 0;
  }

  /// Place of side k in the file's order of sides.
  std::uint32_t forward_side(std::uint32_t k) const { return reversed_ ? size_ - 1 - k : k; }

 private:
  std::uint32_t forward_corner(std::uint32_t k) const { return reversed_ && k != 0 ? size_ - k : k; }

  const ConvexPolygon* polygon_ = nullptr;
  const Point3* points_ = nullptr;
  const std::uint32_t* corners_ = nullptr;
  std::uint32_t size_ = 0;
  bool reversed_ = false;
  Point3 loose_[2];
};

/// A pair in standard position, turned so that both rings run counterclockwise seen from the light's far side:
/// the light is strictly on the positive side of the blocker ring, the blocker strictly on the negative side of an
/// area light's ring.
struct StandardPair {
  Ring light;
  Ring blocker;
  OrientationFilter orientation;
};

/// Requires: pair_position(light, blocker) == Position::standard.
/// Throws:   PreconditionError.
StandardPair standard_pair(const Light& light, const ConvexPolygon& blocker);

/// The same of a pair that is known to be in standard position.
///
/// Requires: `sides` is pair_sides(light, blocker); light and blocker outlive the result.
StandardPair standard_pair(const Light& light, const ConvexPolygon& blocker, const PairSides& sides);

/// The light corners that touch the extremal plane through one blocker side: one corner, or two neighbours
/// (`last` after `first`) if a light side lies in the plane. If the plane holds the whole light (a point light, or a
/// linear light coplanar with the side), `first` and `last` are what the neighbouring sides touch.
struct TouchedCorners {
  std::uint32_t first;
  std::uint32_t last;
  bool holds_light;
};

/// The touched light corners for every side of the blocker, walked around both rings once.
///
/// Cost: O(n + m).
std::vector<TouchedCorners> separating_contacts(const StandardPair& pair);
std::vector<TouchedCorners> supporting_contacts(const StandardPair& pair);

/// A light side whose plane through a blocker corner separates the two.
struct LightSideContact {
  std::uint32_t light_side;
  std::uint32_t blocker_corner;
};

/// All of them, in the cyclic order of the blocker's corners: between the planes of two neighbouring blocker sides the
/// touched light corner moves along exactly the light sides whose separating plane goes through their common corner.
///
/// Requires: `separating` is separating_contacts(pair).
std::vector<LightSideContact> separating_light_contacts(const StandardPair& pair,
                                                        const std::vector<TouchedCorners>& separating);

/// The input elements that name the extremal plane through blocker side k, or through a light side.
BlockerPlane blocker_plane(const StandardPair& pair, std::uint32_t k, const TouchedCorners& touched);
LightPlane light_plane(const StandardPair& pair, const LightSideContact& contact);

/// As extremal_planes(light, blocker).
ExtremalPlanes extremal_planes(const StandardPair& pair);

/// True if the line of a linear light meets the closed blocker. False for other lights.
bool light_line_meets_blocker(const StandardPair& pair);

}  // namespace gnomon
