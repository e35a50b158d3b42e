#pragma once

#include <atomic>
#include <memory>
#include <span>

#include "geometry/visibility/shadow_tree.h"

namespace gnomon {

/// A shadow tree that is built once so many questions have been asked that it pays. Any number of threads may ask; one
/// of them builds it while the others go on without.
///
/// Cost: building takes about as long as 100 questions for each blocker take without it; so no more than twice the time
///       is spent of what would have been best.
class PatientShadowTree {
 public:
  /// Keeps a reference to the blockers.
  PatientShadowTree(const ShadowTree::SmallLight& light, std::span<const ConvexBlocker> blockers);

  /// Counts questions. Returns: the tree, or null as long as there is none.
  const ShadowTree* after(std::size_t questions);

 private:
  ShadowTree::SmallLight light_;
  std::span<const ConvexBlocker> blockers_;
  std::atomic<std::size_t> asked_ = 0;
  std::atomic_flag is_begun_;
  std::unique_ptr<const ShadowTree> tree_;
  std::atomic<const ShadowTree*> ready_ = nullptr;
};

}  // namespace gnomon
