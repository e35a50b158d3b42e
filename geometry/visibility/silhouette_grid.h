#pragma once

/// A grid over the light's plane that finds silhouettes by their boxes. Private to this folder.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/visibility/silhouette.h"

namespace gnomon::viewpoint {

/// Cells over the box of the light, each with the silhouettes whose boxes meet it. Its memory is used again.
///
/// Cost: a silhouette meets four cells at most, on the average over all; so building takes O(n).
class SilhouetteGrid {
 public:
  /// Requires: the first silhouette is the light's, with a finite box; the others' boxes are cut to it.
  void build(std::span<const Silhouette> silhouettes);

  /// Replaces `found` by the blockers' silhouettes, ascending, whose boxes meet the box.
  void find(const FlatBox& box, std::vector<std::uint32_t>& found);

 private:
  /// Cells from `first` to `last` in one direction.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  Range columns(const FlatBox& box) const;
  Range rows(const FlatBox& box) const;
  template <class Visit>
  void for_each_cell(const FlatBox& box, const Visit& visit) const;

  std::span<const Silhouette> silhouettes_;
  std::uint32_t side_ = 1;                ///< number of columns, and of rows
  std::vector<std::uint32_t> ends_;       ///< of each cell, where its silhouettes end in `members_`
  std::vector<std::uint32_t> members_;    ///< silhouettes, cell by cell
  std::vector<std::uint32_t> last_seen_;  ///< of each silhouette, the last search that came upon it
  std::uint32_t search_ = 0;
};

}  // namespace gnomon::viewpoint
