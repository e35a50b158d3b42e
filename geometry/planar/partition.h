#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/contact.h"
#include "geometry/planar/flatland.h"
#include "geometry/planar/sight.h"
#include "geometry/point.h"
#include "geometry/region.h"

namespace gnomon::planar {

/// What a boundary lies on.
enum class BoundaryKind : std::uint8_t {
  blocker,     ///< blocker `element`
  light_line,  ///< the light's line
  event,       ///< the line through the points `near` and `far`
  clip_box,    ///< side `element` of the box: 0 to 3 for x min, x max, y min, y max
};

/// The name of a boundary by input elements.
struct BoundaryName {
  BoundaryKind kind = BoundaryKind::event;
  std::uint32_t element = 0;
  EventPoint near;                        ///< of an event: the point nearer to the light, or on it
  EventPoint far;                         ///< of an event: a blocker's end
  Contact contact = Contact::separating;  ///< of an event: what `near` and `far` belong to lies on opposite sides of it
};

/// "No vertex" of an edge that comes from or goes to infinity, "no face" outside the box.
inline constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// An open piece of a line that bounds faces, or lies inside one and differs from it.
struct PartitionEdge {
  std::uint32_t source = nowhere;
  std::uint32_t target = nowhere;
  std::uint32_t left = nowhere;   ///< the face on the left of the edge as it runs from source to target
  std::uint32_t right = nowhere;  ///< the face on its right
  std::uint32_t name = 0;         ///< index into Partition::names
};

/// An edge as it is met when a face's boundary is walked along.
struct EdgeUse {
  enum class Way : std::uint8_t { forward, backward };
  std::uint32_t edge = 0;
  Way way = Way::forward;
};

/// A face: a connected open set of points with one label.
/// Orientation: the face lies on the left of every boundary cycle; a cycle of an unbounded face may pass through
///              infinity, between an edge without a target and one without a source.
struct PartitionFace {
  Region region = Region::lit;
  bool bounded = true;
  std::vector<std::vector<EdgeUse>> boundary;
  std::vector<std::uint32_t> points;     ///< vertices inside the face whose own region is another one
  std::vector<VisibleInterval> visible;  ///< of a finer partition: what is seen, as seen from one point of the face
};

/// How fine the faces are.
enum class Fineness {
  regions,    ///< faces that share an edge differ in region
  structure,  ///< or in what is visible, as a list of named intervals: the visible fraction is one formula in each face
};

/// The plane, or a box of it, divided by what is seen of one light behind many blockers.
///
/// Definition: the points with f = 1, 0 < f < 1 and f = 0 outside the edges and vertices; each face is a component of
///             the interior of one of these sets. An edge lies between faces of different labels, or inside a face
///             where its own points have another region (a light on a blocker's line throws such shadows).
/// Exactness:  all labels and the whole structure are exact; vertices are constructed exactly, and rounded once when
///             they leave.
class Partition {
 public:
  /// Coordinates rounded to nearest.
  const std::vector<Point2>& vertices() const;
  const std::vector<PartitionEdge>& edges() const;
  const std::vector<PartitionFace>& faces() const;
  const std::vector<BoundaryName>& names() const;
  const Sight& sight() const;
  const std::optional<Box2>& box() const;

  /// The number of faces of a region: its components.
  std::size_t count(Region region) const;

  struct Data;
  explicit Partition(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

struct PartitionOptions {
  Fineness fineness = Fineness::regions;
  std::optional<Box2> box;  ///< nothing: the whole plane, unbounded faces as such
};

/// Divides the plane.
///
/// Requires: a box, if any, with finite coordinates and an interior.
/// Throws:   PreconditionError.
/// Cost:     grows with the arrangement of the event rays, which are cut where no light reaches them.
/// After:    [P93] §4.2.2.2.
Partition partition(const Sight& sight, const PartitionOptions& options = {});

}  // namespace gnomon::planar
