#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/reflection.h"

namespace gnomon::laws {

/// A light, what may hide it, and a surface's point with an eye above it.
struct ReflectionCase {
  Light light;
  std::vector<ConvexBlocker> blockers;
  gnomon::View view;
  ReflectionModel model = ReflectionModel::phong;
  int exponent = 0;
  double share = 0.5;  ///< where a light is cut
};

/// 17 digits, every vertex.
std::string description(const ReflectionCase& drawn);
Example example(const ReflectionCase& drawn);

/// Linear lights of integer ends, parallelograms and triangles, before a point and an eye above it. Horizon and R's
/// plane pass through ends and corners, R through them; the light is seen aslant. Near degeneracy the point is one
/// unit in the last place aside, everything far larger or smaller, exponents reach 10000 and eyes graze.
rc::Gen<ReflectionCase> reflection_cases(Domain domain);

/// The same of linear lights alone.
rc::Gen<ReflectionCase> linear_cases(Domain domain);

/// The light's ends or corners.
std::vector<Point3> corners_of(const Light& light);

/// The light with other ends or corners.
Light with_points(const Light& light, std::vector<Point3> points);

}  // namespace gnomon::laws
