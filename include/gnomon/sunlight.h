#pragma once

/// @file
/// When the sun shines on points through a day.
///
///     #include <gnomon/sunlight.h>
///     int main() {
///       using namespace gnomon;
///       const auto wall = ConvexPolygon::from_points({{-1, -1, 0}, {-1, 1, 0}, {-1, 1, 9}, {-1, -1, 9}});
///       const DaySunlight day({{wall}, {}}, {.latitude = 0, .declination = 0});
///       const SunlitDay there = day.at({{0, 0, 0}});  // the wall stands in the west
///       const bool is_shadow = there.intervals.at(0).end.name.kind == SunEventName::Kind::shadow;
///       return there.intervals.size() == 1 && is_shadow ? 0 : 1;
///     }

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gnomon/point.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// Where the sun goes on one day. Angles in degrees, as doubles that are meant exactly.
///
/// The sun is a point at infinity that runs along one circle, once round in 24 hours of local solar time; the sun's
/// disc, refraction and the equation of time are left to the caller.
struct SunDay {
  double latitude = 0;       ///< north positive, from -90 to 90
  double declination = 0;    ///< from -23.44 to 23.44
  Point3 up = {0, 0, 1};     ///< not zero
  Point3 north = {0, 1, 0};  ///< at right angles to `up`, not zero
};

/// The declination of the sun on day 1 to 366 of a year: 23.44° sin(360° (284 + day) / 365), a convention that is good
/// to a degree.
double declination_of_day(std::uint32_t day);

/// What makes sunlight begin or end.
struct SunEventName {
  enum class Kind {
    midnight,  ///< the day itself, where the sun does not set
    horizon,   ///< the sun rises or sets
    receiver,  ///< it passes the plane of the point's normal
    shadow,    ///< it passes an edge of a blocker
  };
  Kind kind = Kind::horizon;
  std::uint32_t blocker = 0;  ///< index among the obstacles
  std::uint32_t edge = 0;     ///< of a polygon's file order, of a solid's edges

  friend bool operator==(const SunEventName&, const SunEventName&) = default;
};

struct SunEvent {
  double hour = 0;         ///< of local solar time, 12 where the sun is highest
  double error_bound = 0;  ///< at least |hour - exact|, hours
  SunEventName name;
};

struct SunInterval {
  SunEvent start;
  SunEvent end;
};

/// The sunlit times of one point, ascending.
struct SunlitDay {
  std::vector<SunInterval> intervals;
  double hours = 0;        ///< of all intervals together
  double error_bound = 0;  ///< at least |hours - exact|
  bool tied = false;       ///< events follow each other so closely that their order is not certain: taken as one
};

/// A point, perhaps of a receiver: then only the sun before the plane at right angles to the normal counts.
struct SunPoint {
  Point3 point;
  std::optional<Point3> normal = {};
};

/// Sunlit times of points behind obstacles on one day; any number of threads may ask.
///
/// Definition: the sun is above the horizon, before the receiver, and the ray towards it meets no blocker.
/// Degenerate: a polygon in one plane with the point counts as hiding nothing: it hides single moments, but where the
/// sun
///             runs in that plane itself, as it may on an equinox.
/// Method:     the sun crosses the plane through the point and an edge where A cos H + B sin H + C = 0, at most twice a
///             day; a blocker hides it between such moments, in closed form.
/// Exactness:  doubles with bounds; intervals of 200 bits (MPFI) where these do not decide.
/// Cost:       for each point one look at each blocker, and a few formulas for each edge of those that the sun may
/// pass.
class DaySunlight {
 public:
  /// Throws: PreconditionError for angles out of range, or axes that are not at right angles.
  DaySunlight(Obstacles obstacles, const SunDay& day);

  SunlitDay at(const SunPoint& point) const;

  struct Content;

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gnomon
