#pragma once

#include <string>

#include "gnomon/result.h"

namespace gnomon {

/// A result made by hand, whose numbers are known: the square light [-1/2, 1/2]² at z = 4 above the square blocker
/// [-1, 1]² at z = 2, the floor [-4, 4]² at z = 0, cut at z = -1. Occlusion and umbra are frusta over the blocker that
/// end in the squares of half width 13/4 and 7/4; the floor's regions are worked out.
class SampleResult {
 public:
  /// Names may be anything; the blocker stands twice in the scene, once as the member of a pair that is not supported.
  explicit SampleResult(const std::string& light = "lamp", const std::string& blocker = "table");
  SampleResult(const SampleResult&) = delete;
  SampleResult& operator=(const SampleResult&) = delete;

  const ShadowResult& result() const { return result_; }
  ShadowResult& result() { return result_; }

 private:
  Scene scene_;
  ShadowResult result_;
};

/// The same result without an umbra, as a large light makes it, and without divided receivers.
void remove_umbra(ShadowResult& result);

}  // namespace gnomon
