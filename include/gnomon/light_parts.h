#pragma once

/// @file
/// Lights that consist of parts: concave polygons, solids that shine from every facet.
///
///     #include <gnomon/light_parts.h>
///     int main() {
///       using namespace gnomon;
///       const auto lamp = [](double x, double y) {  // shines down from the height 4
///         return AreaLight{ConvexPolygon::from_points({{x, 0, 4}, {x, y, 4}, {x + 1, y, 4}, {x + 1, 0, 4}})};
///       };
///       const ConvexPolygon board = ConvexPolygon::from_points({{1, 9, 2}, {1, -9, 2}, {9, -9, 2}, {9, 9, 2}});
///       PartsVisibility seen({lamp(0, 1), lamp(1, 3)}, PreparedObstacles({{board}, {}}));
///       return seen.at({1, 0.5, 0}).fraction == 0.25 ? 0 : 1;  // the smaller part is lit, the other one hidden
///     }

#include <memory>
#include <vector>

#include "gnomon/light.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// What points see of a light of several parts: convex pieces of a concave polygon, facets of a solid. One part alone
/// is the light itself, of any kind.
///
/// Definition: parts that show a point their back or their edge take no part; if all do, the point is unlit. Of the
///             others the visible areas are added, as a share of all their area. Lit: every one of them is lit; umbra:
///             all are hidden. At a receiver's point, of those which have anything before its plane. The parts do not
///             hide each other; who wants that makes them blockers, too.
/// Exactness:  as of LightVisibility; adding n parts brings (n + 4) 2^-52 to the bound, and nothing where nothing is
///             visible, or all of all.
/// Cost:       one question for each part that shows its front. Memory is kept for the next, so one object per thread.
class PartsVisibility {
 public:
  /// Throws: PreconditionError unless there is a single light or several area lights, each exactly flat.
  PartsVisibility(std::vector<Light> parts, const PreparedObstacles& obstacles, const LinearSearch& search = {});
  PartsVisibility(PartsVisibility&&) noexcept;
  PartsVisibility& operator=(PartsVisibility&&) noexcept;
  ~PartsVisibility();

  /// Requires: finite coordinates.
  Visibility at(const Point3& p);
  Visibility received(const ReceiverPoint& receiver);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon
