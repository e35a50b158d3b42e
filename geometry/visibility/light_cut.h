#pragma once

/// Where a receiver's plane cuts a flat area light. Private to this folder.

#include <cstdint>
#include <vector>

#include "geometry/visibility/flat_area.h"
#include "geometry/visibility/receiver_front.h"

namespace gnomon::viewpoint {

/// What of a light lies before a receiver's plane.
enum class Extent { none, part, all };

/// A light's side and a receiver's plane.
///
/// Exactness: extent and sides are exact. The height over the receiver's plane is linear in flat coordinates; its three
///            numbers are off by at most u times themselves.
struct LightCut {
  Extent extent = Extent::all;
  std::vector<std::int8_t> sides;  ///< of the receiver's plane on which the light's corners lie
  double share = 1;                ///< of the light that lies before the plane, correctly rounded
  double along_u = 0;
  double along_v = 0;
  double at_origin = 0;
};

/// Replaces the cut by that of a receiver; only of a light that is cut are share and heights worked out.
void cut_light(const LightSide& light, const ReceiverPoint& receiver, LightCut& cut);

/// The height of a flat point over the receiver's plane, and at least its error.
struct FlatHeight {
  double value = 0;
  double error = 0;

  /// -1 or +1 if that is certain.
  std::int8_t side() const { return static_cast<std::int8_t>(value > error ? 1 : value < -error ? -1 : uncertain); }
};

FlatHeight height_of(const FlatPoint& p, const LightCut& cut);

/// Twice the area of what of a region lies before the receiver's plane, from the pieces of the region's boundary as
/// AreaSum takes them.
///
/// Definition: with h the height, g its gradient and h+ the larger of h and 0, the field h+ g / |g|² has divergence 1
///             before the plane and 0 behind it; so the area is what flows out through the boundary.
class AreaBefore {
 public:
  explicit AreaBefore(const LightCut& cut) : cut_(cut) {}
  void add(const FlatPoint& p, const FlatPoint& q);
  FlatArea total() const;

 private:
  const LightCut& cut_;
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace gnomon::viewpoint
