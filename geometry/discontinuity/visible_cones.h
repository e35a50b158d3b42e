#pragma once

/// What a point sees of an area light, as cones of directions between named planes. Private to this folder.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/silhouette_edges.h"
#include "geometry/visibility/visible_part.h"

namespace gnomon::event {

/// The light's cone of directions without the cones of blockers, in convex pieces.
///
/// Definition: all planes go through the point p, and through an edge of the light or a blocker; one may be the
///             receiver's. A corner of a piece is the direction in which two of them meet, in their order. So nothing
///             is constructed from what was constructed, and a sign is that of a determinant of three planes' normals:
///             known where the planes have names in common, else by intervals, else by rationals.
/// Exactness:  exact.
class VisibleCones {
 public:
  VisibleCones(const EventScene& scene, const ReceiverPlane& receiver) : scene_(scene), receiver_(receiver) {}

  /// Looks from a point at what blockers leave of the light before the receiver's plane.
  /// Requires: some point of each blocker lies strictly before the receiver's plane.
  /// Returns:  false if this is not for this level: the light is no polygon, shows its back or edge, or lies in or
  /// behind
  ///           the receiver's plane; a blocker that is not wholly in front of the light, or that p is inside of.
  bool view(const ExactVector& p, std::span<const ShapeId> blockers);

  /// Lit, penumbra or umbra.
  Region region() const;

  /// True if a corner of a piece is a vertex of the light or a blocker, or an end of what the receiver's plane leaves
  /// of the light's edge.
  bool shows_vertex() const;

  /// The same in rationals.
  VisiblePart part(const AreaLight& light) const;

 private:
  /// A plane through p and two points, a < b; or the receiver's.
  struct PlaneThroughPoint {
    PointId a = 0;
    PointId b = 0;
    bool is_receivers = false;
    NearVector normal;
  };
  using PlaneId = std::uint32_t;
  /// In numbers without denominators, whose products need no common divisors.
  using WholeVector = std::array<boost::multiprecision::mpz_int, 3>;

  /// A direction: a positive multiple of sense (normal of first x normal of second).
  struct Corner {
    PlaneId first = 0;
    PlaneId second = 0;
    PlaneId third = 0;  ///< one more that holds it, or one of the two
    int sense = 1;
    NearVector direction;
    PlaneId side = 0;  ///< from here to the next corner
    int inside = 1;    ///< the side of that plane on which the piece lies
  };
  using Piece = std::vector<Corner>;  ///< in the order in which a corner x the next points inside

  /// One of the planes that bound a blocker, which lies on the side `inside`.
  struct Bound {
    PlaneId plane = 0;
    int inside = 1;
  };

  ExactVector exact_way(PointId point) const;
  NearVector to(PointId point) const;
  ExactVector exact_normal(PlaneId plane) const;
  PlaneId plane(PointId a, PointId b);
  int side(PlaneId plane, PointId point) const;
  int sign(PlaneId plane, Corner& corner) const;
  std::optional<PointId> common_point(PlaneId p, PlaneId q) const;
  bool holds(PlaneId plane, const Corner& corner) const;
  ExactVector exact_direction(const Corner& corner) const;
  const WholeVector& whole_normal(PlaneId plane) const;
  Corner crossing(const Corner& from, int sign_at_next, PlaneId plane) const;
  bool add_light();
  bool keep_before_receiver();
  bool cut(Piece& piece, const Bound& bound, Piece* beyond);
  bool append_bounds(const Shape& shape, std::vector<Bound>& bounds);
  void append_outside(Piece& piece, std::span<const Bound> bounds, std::vector<Piece>& pieces);
  bool is_visible_vertex(PointId point) const;
  bool is_visible_vertex(const Corner& corner) const;

  const EventScene& scene_;
  const ReceiverPlane& receiver_;
  Place p_;
  int light_side_ = 1;  ///< of the light's plane, on which p lies
  bool is_cut_ = false;
  std::vector<PlaneThroughPoint> planes_;
  mutable std::vector<std::optional<WholeVector>> whole_normals_;  ///< of planes, where they were asked for
  std::map<std::pair<PointId, PointId>, PlaneId> plane_of_;
  std::vector<Piece> pieces_;
};

}  // namespace gnomon::event
