#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/law.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {

/// A linear light, blockers, and points with a normal that look at it.
struct SearchCase {
  LinearLight light;
  std::vector<ConvexBlocker> blockers;
  std::vector<Point3> points;
  Point3 normal;
};

/// The case as text from which it can be built again: 17 digits, every vertex.
std::string description(const SearchCase& drawn);

/// Every search, those with parts with few, some and many.
const std::vector<LinearSearch>& searches();

/// Cases in which searches may err: few blockers and enough for a hierarchy; they touch the light, are pierced by its
/// line, lie across half a turn about it; points on the light's line, on vertices, in planes of three of them, in line
/// with light and blocker.
rc::Gen<SearchCase> search_cases(Domain domain);

}  // namespace gnomon::laws
