#pragma once

/// @file
/// What points see of a light behind all obstacles together.
///
///     #include <gnomon/visibility.h>
///     int main() {
///       using namespace gnomon;
///       const Light tube = LinearLight{{-1, 0, 4}, {1, 0, 4}};
///       const ConvexPolygon board = ConvexPolygon::from_points({{0, -1, 2}, {3, -1, 2}, {3, 1, 2}, {0, 1, 2}});
///       const Visibility once = light_visibility(tube, {{board}, {}}, {0, 0, 0});
///       LightVisibility often(tube, PreparedObstacles({{board}, {}}));  // the same, made ready for many points
///       return once.fraction == 0.5 && often.at({2, 0, 0}).region == Region::umbra ? 0 : 1;
///     }

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/point.h"

namespace gnomon {

/// Everything that stands between points and lights.
struct Obstacles {
  std::vector<ConvexBlocker> blockers;    ///< their union blocks
  std::vector<ClosedSurface> enclosures;  ///< what a closed mesh encloses; its facets are among the blockers
};

/// The front of a receiver that is a point with a normal: what lies before the plane through the point at right angles
/// to the normal. The normal is not zero; its length does not matter.
struct FacingNormal {
  Point3 normal;
};

/// The front of a receiver that is a facet: what lies before the plane of three of its corners, which run
/// counterclockwise seen from the front. Points of the facet may be off the plane by what was rounded.
struct FacetFront {
  std::array<Point3, 3> corners;
};

/// The front of a convex polygon: the plane through its first three corners.
FacetFront facet_front(const ConvexPolygon& facet);

using ReceiverFront = std::variant<FacingNormal, FacetFront>;

/// A point of a receiver, and the side from which it receives.
struct ReceiverPoint {
  Point3 point;
  ReceiverFront front;
  /// Blockers, by their indices and ascending, that lie under the point and hide nothing from it.
  std::vector<std::uint32_t> under = {};
};

/// What a point receives of a light, without regard to how brightly it shines.
struct Visibility {
  Region region = Region::lit;
  double fraction = 1;     ///< the visible fraction f; 0 where unlit
  double error_bound = 0;  ///< at least |fraction - f|
  /// Of a receiver's point, the share of the light before the receiver's plane: correctly rounded, or for lights that
  /// are not flat next to that. Of a bare point 1.
  double before_receiver = 1;

  friend bool operator==(const Visibility&, const Visibility&) = default;
};

/// What a point sees of a light behind all obstacles together.
///
/// Definition: a point l of the light is hidden if the open segment (p, l), for a directional light the open ray, meets
///             a blocker. f is the share of what is not hidden, by area or length; for a point or a direction 1 or 0.
///             Lit: f = 1. Umbra: f = 0, and every point strictly inside a solid or an enclosure. Unlit: in the plane
///             of an area light or behind a one-sided one; this takes precedence.
/// Degenerate: every position of light, blockers and point. A grazing contact hides point and directional lights, and
///             changes nothing for the others, as it has no area or length. A point on a flat blocker sees both sides.
/// Exactness:  the region is decided in rational arithmetic. `fraction` is the double nearest to f, but where f had to
///             be enclosed (to 2^-190, for lights whose vertices are not exactly coplanar and for more than 64 pieces)
///             it may be a neighbour that is as near up to the enclosure.
/// Cost:       rational arithmetic for every blocker that may reach the light; meant as a reference.
Visibility exact_visibility(const Light& light, const Obstacles& obstacles, const Point3& p);

/// What a receiver's point receives of a light behind all obstacles together.
///
/// Definition: of the light counts what lies strictly before the receiver's plane (L+). Unlit: nothing of it, or none
///             that has an area or length, or the light shows its back or edge. Else the limit from the front is meant,
///             from the point moved by e along the receiver's normal, e -> 0. Lit: nothing of L+ is hidden; umbra: all
///             of it, and inside solids and enclosures. f is the visible part of L+ as a share of the whole light. So
///             with lights that emit alike everywhere the irradiance is positive exactly where lit or in penumbra.
/// Degenerate: every position. Blockers wholly in or behind the plane hide nothing, so a plate that is blocker and
///             receiver does not hide the light from itself. A point on an enclosure's surface is not enclosed.
/// Exactness:  as above; nothing is moved, signs that are 0 are decided by how they grow along the normal.
Visibility exact_received(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver);

/// Obstacles made ready for many points. Copies share their content; any number of threads may read it.
class PreparedObstacles {
 public:
  explicit PreparedObstacles(Obstacles obstacles);

  const Obstacles& obstacles() const;

  struct Content;
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

/// How blockers are found that may hide a linear light from a point. Which one is taken changes no answer, only time
/// and memory. After: [PA90] §5, [P93] §4.3.
enum class OccluderSearch {
  plane,            ///< every blocker is held against the plane through point and light
  hierarchy,        ///< a hierarchy of boxes, the same for every light
  grid,             ///< n x n x n voxels, in which the triangle between point and light is scan-converted
  light_buffer,     ///< n sections about the light, each with lists by distance
  light_hierarchy,  ///< a hierarchy of boxes in cylindrical coordinates about the light
};

inline constexpr std::array occluder_searches = {OccluderSearch::plane, OccluderSearch::hierarchy, OccluderSearch::grid,
                                                 OccluderSearch::light_buffer, OccluderSearch::light_hierarchy};

/// The search's name as scripts read it.
constexpr std::string_view name(OccluderSearch search) {
  constexpr std::string_view names[] = {"plane", "hierarchy", "grid", "light_buffer", "light_hierarchy"};
  return names[static_cast<int>(search)];
}

/// The largest number of parts that a search takes: voxels along a side of the grid, sections of the buffer; 0 for
/// those that have none.
constexpr std::uint32_t most_parts(OccluderSearch search) {
  return search == OccluderSearch::grid ? 100 : search == OccluderSearch::light_buffer ? 10000 : 0;
}

/// The number that is taken where none is asked for.
constexpr std::uint32_t usual_parts(OccluderSearch search) {
  return search == OccluderSearch::grid ? 25 : search == OccluderSearch::light_buffer ? 360 : 0;
}

/// A search and the number of its parts; 0 for the usual one.
struct LinearSearch {
  OccluderSearch strategy = OccluderSearch::light_hierarchy;
  std::uint32_t parts = 0;

  friend bool operator==(const LinearSearch&, const LinearSearch&) = default;
};

/// What points see of one light: asked at the fast level, and at the exact level where that one does not decide.
///
/// Definition: exact_visibility.
/// Exactness:  the region is exact. The fraction is within its bound, which is at most 1e-6: where the fast level has
///             no better one, the exact level is asked as well.
/// Cost:       memory is kept for the next question, so one object per thread.
class LightVisibility {
 public:
  /// Throws: PreconditionError for more parts than the search takes.
  LightVisibility(Light light, PreparedObstacles obstacles, const LinearSearch& search = {});
  LightVisibility(LightVisibility&&) noexcept;
  LightVisibility& operator=(LightVisibility&&) noexcept;
  ~LightVisibility();

  /// Requires: finite coordinates.
  Visibility at(const Point3& p);
  Visibility received(const ReceiverPoint& receiver);

  /// How many questions went to the exact level.
  std::size_t exact_answers() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// The same for one point alone, nothing kept.
Visibility light_visibility(const Light& light, const Obstacles& obstacles, const Point3& p);

/// A point with a normal as a receiver's point, with the blockers that it rests on: they lie under it and hide nothing
/// from it. So a point that was computed on a facet and rounded is not hidden by that facet, on which side of it
/// rounding may have put it.
///
/// Definition: a point is within rounding of a facet if it would meet the facet after each of its coordinates is moved
///             by at most 8 u of the larger of its own size and that of the facet's corners. It rests on the facet if
///             it is so but not within rounding of the facet's sides, and the planes of receiver and facet, of a solid
///             its outer side, make an angle of at most 60 degrees. Sides beyond
///             which another such facet goes on, coplanar with it but for rounding, do not count. A thin solid between
///             vertices that were rounded off their plane is one facet with two sides.
/// Exactness:  rational arithmetic where doubles do not decide. A point that lies exactly on a facet rests on it too.
ReceiverPoint resting_point(const PreparedObstacles& obstacles, const Point3& p, const Point3& normal);

/// True if the point is within rounding of a blocker's facet and not on its plane: rounding may have put it on the
/// wrong side.
bool is_within_rounding(const PreparedObstacles& obstacles, const Point3& p);

}  // namespace gnomon
