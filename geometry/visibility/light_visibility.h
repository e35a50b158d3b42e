#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/fast_point_visibility.h"
#include "geometry/visibility/fast_visibility.h"
#include "geometry/visibility/visibility.h"

namespace gnomon {

/// Obstacles made ready for many points. Copies share their content; any number of threads may read it.
class PreparedObstacles {
 public:
  explicit PreparedObstacles(Obstacles obstacles);

  const Obstacles& obstacles() const { return *obstacles_; }
  const BlockerSet& blockers() const { return blockers_; }

  /// True if the point may lie in an enclosure: it lies in the box around one.
  bool may_enclose(const Point3& p) const;

 private:
  std::shared_ptr<const Obstacles> obstacles_;
  BlockerSet blockers_;
  std::vector<Box3> enclosures_;
};

/// The fast level for any light.
using FastLevel = std::variant<FastPointVisibility, FastLinearVisibility, FastVisibility>;

FastLevel fast_level(const Light& light, const BlockerSet& blockers);

/// What points see of one light: asked at the fast level, and at the exact level where that one does not decide.
///
/// Definition: exact_visibility.
/// Exactness:  the region is exact. The fraction is within its bound, which is at most 1e-6: where the fast level has
///             no better one, the exact level is asked as well.
/// Cost:       memory is kept for the next question, so one object per thread.
class LightVisibility {
 public:
  LightVisibility(Light light, PreparedObstacles obstacles);

  /// Requires: finite coordinates.
  Visibility at(const Point3& p);

  /// How many questions went to the exact level.
  std::size_t exact_answers() const { return exact_answers_; }

 private:
  std::optional<Visibility> fast_answer(const Point3& p);

  Light light_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
  std::size_t exact_answers_ = 0;
};

}  // namespace gnomon
