#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "gnomon/blocker.h"
#include "gnomon/point.h"

namespace gnomon::report {

/// Shadow rays of Embree 3 behind blockers, as triangles in floats.
class EmbreeRays {
 public:
  explicit EmbreeRays(std::span<const ConvexBlocker> blockers);
  EmbreeRays(EmbreeRays&&) noexcept;
  EmbreeRays& operator=(EmbreeRays&&) noexcept;
  ~EmbreeRays();

  /// Whether the way to what lies `towards` a point is hidden.
  bool is_hidden(const Point3& p, const Point3& towards);

  /// At most eight rays from one point, told to be coherent. Returns: bit i if the ray to end i is hidden.
  unsigned hidden_of_eight(const Point3& p, std::span<const Point3> ends);

  /// What Embree holds for the blockers.
  std::size_t bytes() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon::report
