#pragma once

/// A hierarchy of boxes, searched with anything that can tell whether a box may meet it: half-spaces, a pyramid, a
/// line, another box.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gnomon/point.h"

namespace gnomon {

/// Boxes by number.
class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  explicit BoxHierarchy(const std::vector<Box3>& boxes);

  bool empty() const { return branches_.empty(); }

  /// Replaces `found` by the numbers of all boxes that may meet what is searched with, and some others, in no order.
  /// Requires: `may_meet(box)` is true if it is true of some box inside.
  /// Returns:  the number of nodes visited.
  template <class MayMeet>
  std::size_t search(const MayMeet& may_meet, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (empty()) return 0;
    std::size_t visited = 0;
    std::array<std::uint32_t, 128> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
      const Branch& branch = branches_[stack[--depth]];
      ++visited;
      if (!may_meet(branch.box)) continue;
      for (std::uint32_t i = 0; i < branch.count; ++i) {
        const std::uint32_t k = branch.first + i;
        if (branch.count == 1 || may_meet(boxes_[k])) found.push_back(order_[k]);
      }
      if (branch.count > 0) continue;
      stack[depth++] = branch.first;
      stack[depth++] = branch.first + 1;
    }
    return visited;
  }

 private:
  struct Branch {
    Box3 box;
    std::uint32_t first = 0;  ///< leaf: first in order_; else the first child
    std::uint32_t count = 0;  ///< leaf: number of boxes; else 0
  };
  void build(const std::vector<Box3>& boxes, std::uint32_t branch, std::uint32_t first, std::uint32_t last);

  std::vector<std::uint32_t> order_;  ///< numbers of boxes, as the leaves have them
  std::vector<Box3> boxes_;           ///< in this order
  std::vector<Branch> branches_;
};

}  // namespace gnomon
