#pragma once

#include "gnomon/result.h"

namespace gnomon {

/// A result of the plane whose numbers are known: the tube from (-1/2, 4) to (1/2, 4) above the wall from (-1, 2) to
/// (1, 2), the floor at y = 0, cut at y = -1. From the wall down by 3 the half width of the umbra grows from 1 to 7/4,
/// that of the occlusion to 13/4.
class PlanarSample {
 public:
  PlanarSample();
  PlanarSample(const PlanarSample&) = delete;
  PlanarSample& operator=(const PlanarSample&) = delete;

  const ShadowResult& result() const { return result_; }

 private:
  Scene scene_;
  ShadowResult result_;
};

}  // namespace gnomon
