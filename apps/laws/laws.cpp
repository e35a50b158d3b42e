#include "apps/laws/any_position_laws.h"
#include "apps/laws/flatland_claims.h"
#include "apps/laws/flatland_laws.h"
#include "apps/laws/planar_laws.h"
#include "apps/laws/sight_laws.h"
#include "apps/laws/spatial_laws.h"

namespace gnomon::laws {

std::vector<Law> all_laws() {
  std::vector<Law> all;
  for (const auto& family :
       {planar_laws(), flatland_laws(), flatland_claims(), spatial_laws(), any_position_laws(), sight_laws()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace gnomon::laws
