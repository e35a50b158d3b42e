#include <algorithm>
#include <utility>

#include "apps/proof/laws/law_lists.h"

namespace gnomon::laws {

std::vector<Law> all_laws() {
  std::vector<Law> all;
  for (const auto& family :
       {planar_laws(), flatland_laws(), flatland_claims(), spatial_laws(), any_position_laws(), visibility_laws(),
        event_laws(), event_count_laws(), receiver_laws(), triple_edge_laws(), search_laws(), tree_laws(),
        spatial_claims(), reflection_laws(), reflection_claims(), design_laws(), design_claims()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  const std::vector<std::string> order = all_keys();
  // An entry "S6_any" follows S6: the same statement of more pairs.
  const auto place = [&](const Law& law) {
    return std::ranges::find(order, law.key.substr(0, law.key.find('_'))) - order.begin();
  };
  std::ranges::stable_sort(all, {}, place);
  return all;
}

std::vector<std::string> all_keys() {
  const std::pair<std::string, int> families[] = {{"P", 10}, {"Q", 6},  {"S", 15}, {"M", 5}, {"E", 7}, {"T", 9},
                                                  {"LL", 3}, {"ST", 1}, {"F", 7},  {"H", 8}, {"G", 9}};
  std::vector<std::string> keys;
  for (const auto& [letter, last] : families) {
    for (int number = 1; number <= last; ++number) keys.push_back(letter + std::to_string(number));
  }
  for (const char* key : {"D1", "D4", "D6", "D7", "D8", "D9", "D10", "X4"}) keys.emplace_back(key);
  return keys;
}

}  // namespace gnomon::laws
