#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "gnomon/blocker.h"

namespace gnomon {

/// Blockers made ready for being looked at from many points: their corners in one piece of memory, and a hierarchy of
/// boxes over them.
///
/// Blocker i is the i-th of those given. Copies share their content; any number of threads may read it.
/// Cost: O(n log n); about 400 bytes for a triangle.
class BlockerSet {
 public:
  explicit BlockerSet(std::span<const ConvexBlocker> blockers);

  /// The number of blockers.
  std::size_t size() const;

  /// What the set consists of; known to geometry/visibility alone.
  struct Content;
  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gnomon
