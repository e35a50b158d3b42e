#pragma once

/// A hierarchy over boxes, searched with a pyramid or a line. Private to this folder.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/visibility/blocker_content.h"

namespace gnomon {

/// The tree over the boxes; box i is named i.
std::shared_ptr<const BoxTree> box_tree(std::span<const Box3> boxes);

/// Appends the names of all boxes that meet the pyramid, and of some others, in no order.
/// Exactness: conservative.
void append_boxes_in(const BoxTree& tree, const LightPyramid& pyramid, std::vector<std::uint32_t>& found);

/// Appends the names of all boxes that meet the line, and of some others, in no order.
/// Requires:  coordinates of at most 1e30.
/// Exactness: conservative.
void append_boxes_along(const BoxTree& tree, const SightLine& line, std::vector<std::uint32_t>& found);

/// Appends the names of all boxes that meet the box, in no order.
void append_boxes_near(const BoxTree& tree, const Box3& box, std::vector<std::uint32_t>& found);

}  // namespace gnomon
