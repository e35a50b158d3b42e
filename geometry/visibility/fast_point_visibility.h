#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/receiver_front.h"
#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/point.h"

namespace gnomon {

class PatientShadowTree;
class ShadowTree;

/// The fast level of visibility for a light without size: does the one line of sight to it meet a blocker?
///
/// Definition: hidden if the open segment to a point light, the open ray towards a directional one, meets a blocker, or
///             the point lies strictly inside a solid.
/// Exactness:  exact: signs of determinants of input points.
/// Cost:       a search in the hierarchy along the line of sight, and a few signs for each blocker it finds. Memory is
///             kept for the next question, so one object per thread.
class FastPointVisibility {
 public:
  using SmallLight = std::variant<PointLight, DirectionalLight>;

  FastPointVisibility(SmallLight light, BlockerSet blockers);
  /// With a shadow tree of the same light and blockers, once that is built. It changes no answer, only who gives it:
  /// where this level leaves a point to the exact one the tree may decide.
  FastPointVisibility(SmallLight light, BlockerSet blockers, std::shared_ptr<PatientShadowTree> tree);

  /// Lit or umbra, or nothing if that is left to the exact level: the line of sight runs in a flat blocker's plane, the
  /// point is the light, or a coordinate exceeds 1e30.
  ///
  /// Requires: finite coordinates.
  std::optional<Region> region_from(const Point3& point);

  /// The same for a point of a receiver, after exact_received: lit, umbra or unlit.
  ///
  /// Returns: nothing also where a blocker may hold the point, or its edge touches the line of sight that is else
  ///          hidden.
  std::optional<Region> region_of(const ReceiverPoint& receiver);

 private:
  std::optional<Region> region_from(const Point3& point, const ReceiverPoint* receiver);
  std::optional<Region> region_by_tree(const Point3& point);

  SmallLight light_;
  BlockerSet blockers_;
  std::vector<std::uint32_t> candidates_;
  std::vector<int> sides_;  ///< of a solid's facets, on which the point lies
  std::shared_ptr<PatientShadowTree> patient_;
  const ShadowTree* tree_ = nullptr;
  std::size_t untold_ = 0;  ///< questions that the patient tree has not been told of
};

}  // namespace gnomon
