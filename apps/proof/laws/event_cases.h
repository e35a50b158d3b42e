#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::laws {

/// What of a shape is put on the line of sight.
enum class OnLine {
  vertex,
  edge,
  facet,   ///< a facet or a flat shape, in the plane of the line and of the case's `across`
  inside,  ///< of a light: a point of its inside
};

/// A part of the light or of a blocker that a line of sight meets, and its points: one of a vertex, two of an edge.
struct LinedUp {
  int of = -1;  ///< number of the blocker; -1: the light
  OnLine what = OnLine::vertex;
  std::vector<Point3> points;
  std::uint32_t index = 0;  ///< as events are named: of a vertex, an edge or a facet
};

/// A point of space, a point of the light, and elements made to lie on the segment between them: an event, if nothing
/// else stands in the way. And a direction in which a path crosses it.
struct EventCase {
  Light light;
  std::vector<ConvexBlocker> blockers;
  Point3 point;
  Point3 on_light;
  Point3 across;  ///< spans, with the segment, the plane of what was drawn to be coplanar
  Point3 direction;
  std::vector<LinedUp> elements;  ///< from the point on; the light's is the last
  int choice = 0;                 ///< 0 to 3: what is looked at
};

std::string description(const EventCase& drawn);
Example example(const EventCase& drawn);
void count_regions(const EventCase& drawn, Census& census);

/// What is drawn to be in line: the parts of blockers from the point on, and that of the light.
struct EventMix {
  std::vector<OnLine> blockers;
  OnLine light;
  bool coplanar = false;  ///< edges lie in one plane with the segment
};

enum class EventLight { linear, area };

/// Events of one of the given kinds, made so and not searched for: every element is built around a whole-numbered point
/// of the line of sight, flat or solid, and now and then one more blocker is added. Near degeneracy vertices beside the
/// event are off its plane by 2^-40 or one ulp only, everything is far from the origin with small detail or stretched,
/// and the path is nearly tangential.
rc::Gen<EventCase> event_cases(Domain domain, EventLight light, const std::vector<EventMix>& kinds);

}  // namespace gnomon::laws
