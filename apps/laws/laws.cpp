#include "apps/laws/law.h"

namespace gnomon::laws {

std::vector<Law> all_laws() {
  std::vector<Law> all;
  for (const auto& family : {spatial_laws()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace gnomon::laws
