#include "geometry/visibility/patient_shadow_tree.h"

#include <utility>

namespace gnomon {
namespace {

/// Questions a blocker before a tree is built; with few blockers it gains nothing, with many it takes too much room.
constexpr std::size_t patience = 100;
constexpr std::size_t fewest_blockers = 4;
constexpr std::size_t most_blockers = 20'000;

}  // namespace

PatientShadowTree::PatientShadowTree(const ShadowTree::SmallLight& light, std::span<const ConvexBlocker> blockers)
    : light_(light), blockers_(blockers) {}

const ShadowTree* PatientShadowTree::after(std::size_t questions) {
  if (const ShadowTree* tree = ready_.load(std::memory_order_acquire)) return tree;
  const std::size_t n = blockers_.size();
  if (n < fewest_blockers || n > most_blockers) return nullptr;
  if (asked_.fetch_add(questions, std::memory_order_relaxed) + questions < patience * n) return nullptr;
  if (is_begun_.test_and_set()) return nullptr;
  tree_ = std::make_unique<const ShadowTree>(light_, blockers_);
  ready_.store(tree_.get(), std::memory_order_release);
  return tree_.get();
}

}  // namespace gnomon
