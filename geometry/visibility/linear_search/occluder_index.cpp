#include "geometry/visibility/linear_search/occluder_index.h"

#include <algorithm>
#include <utility>

#include "gnomon/errors.h"

namespace gnomon::viewpoint {
namespace {

static_assert(LinearLightOccluders<HierarchySearch> && LinearLightOccluders<PlaneSearch> &&
              LinearLightOccluders<VoxelGrid> && LinearLightOccluders<LightBuffer> &&
              LinearLightOccluders<LightHierarchy>);

}  // namespace

OccluderIndex::Search OccluderIndex::search_of(const LinearLight& light, const BlockerSet& blockers,
                                               const LinearSearch& search) {
  if (search.parts > most_parts(search.strategy)) throw PreconditionError("a search for occluders has too many parts");
  // Nothing is asked where coordinates are out of range: see FastLinearVisibility.
  const bool in_range = is_in_range(light.start) && is_in_range(light.end) && blockers.content().largest <= largest;
  if (!in_range || light.start == light.end || blockers.size() == 0) return HierarchySearch(blockers);
  const std::uint32_t parts = search.parts > 0 ? search.parts : usual_parts(search.strategy);
  switch (search.strategy) {
    case OccluderSearch::plane:
      return PlaneSearch(blockers);
    case OccluderSearch::hierarchy:
      return HierarchySearch(blockers);
    case OccluderSearch::grid:
      return VoxelGrid(blockers, parts);
    case OccluderSearch::light_buffer:
      return LightBuffer(light, blockers, parts);
    case OccluderSearch::light_hierarchy:
      break;
  }
  return LightHierarchy(light, blockers);
}

OccluderIndex::OccluderIndex(const LinearLight& light, BlockerSet blockers, const LinearSearch& search)
    : blockers_(std::move(blockers)), search_(search_of(light, blockers_, search)) {}

void OccluderIndex::find(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const {
  std::visit([&](const auto& search) { search.find_candidates(triangle, found, counts); }, search_);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  counts.candidates += found.size();
}

std::size_t OccluderIndex::references() const {
  return std::visit([](const auto& search) { return search.references(); }, search_);
}

}  // namespace gnomon::viewpoint
