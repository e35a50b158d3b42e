#pragma once

/// The region of a point by intervals, where these tell. Private to this folder.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/silhouette_vertices.h"
#include "geometry/discontinuity/vertex_shadows.h"
#include "gnomon/names.h"

namespace gnomon::event {

/// What is known of a point's region.
struct QuickAnswer {
  Region region = Region::lit;
  bool is_certain_of_face = false;  ///< a vertex is seen before the light, or all of it: no triple-edge event ends that
  std::optional<ShapeId> cover{};   ///< umbra: a blocker that hides all of the light
  /// Penumbra: a light vertex that is seen, and one that is hidden, if such are known.
  std::optional<std::array<std::uint32_t, 2>> witness{};
};

/// Answers for one receiver, some of the light before its plane.
class QuickVisibility {
 public:
  QuickVisibility(const EventScene& scene, const VertexShadows& shadows, std::uint32_t receiver,
                  const LightBefore& light)
      : scene_(scene),
        shadows_(shadows),
        receiver_(scene.receivers[receiver]),
        light_(light),
        known_(scene.shapes.size(), 0),
        places_(scene.points.size()),
        seen_(scene) {}

  /// The region of a point of the receiver, given the blockers that may hide something from it; nothing if intervals do
  /// not tell.
  std::optional<QuickAnswer> region(const PointEnclosure& p, std::span<const ShapeId> near);

 private:
  /// Where a point lies, once it is known.
  struct Place {
    bool is_known = false;
    bool is_before_plane = false;
    std::int8_t light_side = 0;
  };

  const Place& place(PointId p);
  bool hides_nothing(ShapeId shape);
  void collect_hiding(std::span<const ShapeId> near);
  bool is_beside_light(const Shape& shape, const PointEnclosure& p) const;
  bool is_in_light(PointId v, const PointEnclosure& p, int before);
  bool shows_vertex(const PointEnclosure& p, int before);
  bool is_hidden(std::uint32_t light_vertex, const PointEnclosure& p, bool& is_seen);
  std::optional<ShapeId> cover_of_all(const PointEnclosure& p) const;
  std::optional<QuickAnswer> region_of_visible_vertices(const PointEnclosure& p, int before);
  int side(const PointEnclosure& p, PointId a, PointId b, PointId c) const;

  const EventScene& scene_;
  const VertexShadows& shadows_;
  const Shape& receiver_;
  const LightBefore& light_;
  std::vector<std::int8_t> known_;  ///< of each shape: 0 not yet, 1 may hide something, 2 hides nothing
  std::vector<Place> places_;       ///< of each point
  std::vector<ShapeId> hiding_;     ///< shapes that may hide something from the point that is asked for
  std::vector<ShapeId> cover_;      ///< of these, one for each light vertex that is known to be hidden
  SilhouetteVertices seen_;
};

}  // namespace gnomon::event
