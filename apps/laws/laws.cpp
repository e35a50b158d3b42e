#include "apps/laws/planar_laws.h"
#include "apps/laws/sight_laws.h"
#include "apps/laws/spatial_laws.h"

namespace gnomon::laws {

std::vector<Law> all_laws() {
  std::vector<Law> all;
  for (const auto& family : {planar_laws(), spatial_laws(), sight_laws()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace gnomon::laws
