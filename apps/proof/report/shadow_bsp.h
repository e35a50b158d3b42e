#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "apps/proof/report/visibility_tasks.h"
#include "gnomon/point.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon::report {

/// The union of convex volumes as a binary tree of their planes, as [CF91] keeps occlusions and umbrae of an area
/// light: a peer, in plain doubles with a tolerance.
class ShadowBsp {
 public:
  ShadowBsp();
  ~ShadowBsp();

  /// Adds a convex volume, as its closed surface; sides of a clip box are no planes of it.
  void add(const VolumeMesh& volume);

  std::size_t nodes() const;  ///< inner ones and leaves
  std::size_t height() const;
  /// How many nodes a point comes through, the leaf not counted.
  std::size_t path(const Point3& p) const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// One tree of [CF91]'s Figure 29.
struct BspRow {
  std::string tree;
  double nodes = 0, height = 0, path = 0;  ///< means, where there are several trees
  std::size_t volumes = 0;
};

struct BoxesResult {
  std::vector<BspRow> trees;
  std::size_t receivers = 0, faces = 0;  ///< of the exact division of all of them
};

/// Three boxes on a floor under a square lamp, as [CF91]'s scene Boxes may have been: its figures are lost.
BoxesResult boxes_trees(Effort effort);

std::string boxes_section(const BoxesResult& result);

}  // namespace gnomon::report
