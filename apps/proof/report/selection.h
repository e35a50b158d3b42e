#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "apps/proof/report/measurement.h"

namespace gnomon::report {

/// The measurements of one task, by size.
inline std::map<std::size_t, std::vector<Measurement>> by_size(const std::vector<Measurement>& all,
                                                               const std::string& task) {
  std::map<std::size_t, std::vector<Measurement>> found;
  for (const Measurement& m : all) {
    if (m.task == task) found[m.size].push_back(m);
  }
  return found;
}

/// The methods that occur, each once, in order.
inline std::vector<std::string> methods_of(const std::vector<Measurement>& all) {
  std::vector<std::string> names;
  for (const Measurement& m : all) {
    if (names.empty() || std::find(names.begin(), names.end(), m.method) == names.end()) names.push_back(m.method);
  }
  return names;
}

/// The methods that look at points on the light.
inline constexpr std::array sampling_methods = {"embree_regular", "embree_jittered", "embree_stratified",
                                                "embree_packets"};

/// What a method is called in plots and tables.
inline std::string title_of(const std::string& method) {
  static const std::map<std::string, std::string> titles = {{"exact", "gnomon, exact level"},
                                                            {"gnomon", "gnomon, certified doubles"},
                                                            {"plain_doubles", "plain doubles, no bounds"},
                                                            {"polygon_set_2", "CGAL Polygon_set_2"},
                                                            {"embree_regular", "Embree, regular point lights"},
                                                            {"embree_jittered", "Embree, jittered point lights"},
                                                            {"embree_stratified", "Embree, stratified samples"},
                                                            {"embree_packets", "Embree, the same in packets of eight"},
                                                            {"convex_hull_3", "CGAL convex_hull_3"},
                                                            {"nef_3", "CGAL Nef_polyhedron_3"},
                                                            {"exact_mesh", "gnomon, receiver mesh"},
                                                            {"gnomon_raster", "gnomon at raster points"},
                                                            {"embree_raster", "Embree at raster points"}};
  const auto found = titles.find(method);
  return found == titles.end() ? method : found->second;
}

}  // namespace gnomon::report
