#pragma once

/// Private to geometry/visibility.

#include "geometry/visibility/linear_search/light_cylinder.h"
#include "geometry/visibility/linear_search/light_triangle.h"

namespace gnomon::viewpoint {

/// An endless cylinder about the light, in sections like those of an orange, each with lists of the blockers that may
/// reach it left of the light, beside it and right of it, by distance.
///
/// A point left of the light is hidden by what is left and beside; one beside by what is beside alone.
/// Cost:  memory for a blocker in each section and list that it may reach.
/// After: [P93] §4.3.3, [PA90] §5.
class LightBuffer {
 public:
  LightBuffer(const LinearLight& light, BlockerSet blockers, std::uint32_t sections);

  /// Near the light's line, where there is no section, the search of BlockerSet is taken.
  void find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const;

  std::size_t references() const { return members_.size(); }

 private:
  enum class Region : std::uint32_t { left, beside, right };
  static constexpr std::size_t regions = 3;
  struct Member {
    double distance = 0;  ///< of the blocker, at least
    std::uint32_t blocker = 0;
  };

  std::int64_t section_of(double turn) const;
  std::size_t list_of(std::int64_t section, Region region) const;
  template <class Visit>
  void for_each_list(const CylinderBox& box, const Visit& visit) const;

  BlockerSet blockers_;
  LightCylinder cylinder_;
  std::uint32_t sections_;
  std::vector<std::size_t> ends_;  ///< of each section's lists, where they end in `members_`
  std::vector<Member> members_;
};

}  // namespace gnomon::viewpoint
