#pragma once

#include "gnomon/names.h"

namespace gnomon::report {

/// What a method that claims no bound says of a point.
struct VisibilityAnswer {
  Region region = Region::lit;
  double fraction = 0;
  double irradiance = 0;  ///< of radiance 1
};

}  // namespace gnomon::report
