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

  /// True if the point is enclosed: see is_enclosed. Where it lies in the box around no enclosure this is quick.
  template <class Looking>
  bool encloses(const Looking& p) const {
    return may_enclose(place_of(p)) && is_enclosed(*obstacles_, p);
  }

 private:
  static const Point3& place_of(const Point3& p) { return p; }
  static const Point3& place_of(const ReceiverPoint& receiver) { return receiver.point; }
  bool may_enclose(const Point3& p) const;

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
  Visibility received(const ReceiverPoint& receiver);

  /// How many questions went to the exact level.
  std::size_t exact_answers() const { return exact_answers_; }

 private:
  template <class Looking>
  std::optional<Visibility> fast_answer(const Looking& p);
  template <class Looking>
  Visibility answer(const Looking& p);

  Light light_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
  std::size_t exact_answers_ = 0;
};

}  // namespace gnomon
