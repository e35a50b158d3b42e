#pragma once

#include <memory>
#include <mutex>
#include <variant>
#include <vector>

#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/fast_point_visibility.h"
#include "geometry/visibility/fast_visibility.h"
#include "geometry/visibility/patient_shadow_tree.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// True if the point lies strictly inside an enclosure. Of a receiver's point: and none of the enclosure's triangles
/// lies in the receiver's plane, and it rests on none.
bool is_enclosed(const Obstacles& obstacles, const Point3& p);
bool is_enclosed(const Obstacles& obstacles, const ReceiverPoint& receiver);

struct PreparedObstacles::Content {
  explicit Content(Obstacles given);

  /// True if the point is enclosed: see is_enclosed. Where it lies in the box around no enclosure this is quick.
  template <class Viewer>
  bool encloses(const Viewer& p) const {
    return may_enclose(place_of(p)) && is_enclosed(obstacles, p);
  }

  /// The blockers made ready for one linear light. Whoever asks for the same, on whatever thread, gets the same.
  std::shared_ptr<const viewpoint::OccluderIndex> occluders(const LinearLight& light, const LinearSearch& search) const;

  /// A shadow tree of all blockers under a light without size, shared likewise.
  std::shared_ptr<PatientShadowTree> shadow_tree(const ShadowTree::SmallLight& light) const;

  Obstacles obstacles;
  BlockerSet blockers;

 private:
  /// What was made and may still be in use.
  struct Made {
    Point3 start, end;
    LinearSearch search;
    std::weak_ptr<const viewpoint::OccluderIndex> index;
  };
  static const Point3& place_of(const Point3& p) { return p; }
  static const Point3& place_of(const ReceiverPoint& receiver) { return receiver.point; }
  bool may_enclose(const Point3& p) const;

  struct Planted {
    bool is_sun;
    Point3 place;  ///< or direction
    std::weak_ptr<PatientShadowTree> tree;
  };

  std::vector<Box3> enclosures_;
  mutable std::mutex making_;
  mutable std::vector<Made> made_;        ///< guarded by making_
  mutable std::vector<Planted> planted_;  ///< likewise
};

/// The fast level for any light.
using FastLevel = std::variant<FastPointVisibility, FastLinearVisibility, FastVisibility>;

/// Whether lights without size may grow shadow trees: where it is told which level answered they must not, for that
/// would depend on when a tree is ready.
enum class Trees { none, grown };

FastLevel fast_level(const Light& light, const PreparedObstacles& obstacles, const LinearSearch& search, Trees trees);

}  // namespace gnomon
