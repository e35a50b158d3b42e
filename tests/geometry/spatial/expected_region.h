#pragma once

/// What the volumes of a pair say of a point, for comparison with what the point sees.

#include <algorithm>
#include <optional>

#include "apps/proof/laws/exact.h"
#include "gnomon/names.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

inline bool is_extended(const Light& light) {
  return std::holds_alternative<LinearLight>(light) || std::holds_alternative<AreaLight>(light);
}

/// On the blocker's plane, where a flat blocker's volumes say nothing of single points; on a solid's surface likewise.
inline bool is_on_blocker(const ConvexBlocker& blocker, const Point3& p) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    const auto corner = [&](std::size_t k) { return polygon->points()[polygon->corners()[k]]; };
    return laws::plane_through(laws::exact(corner(0)), laws::exact(corner(1)), laws::exact(corner(2)))
               .side(laws::exact(p)) == 0;
  }
  const ConvexSolid& solid = std::get<ConvexSolid>(blocker);
  return std::all_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    const auto at = [&](std::size_t k) { return laws::exact(solid.points()[facet.loop[k]]); };
    return laws::plane_through(at(0), at(1), at(2)).side(laws::exact(p)) <= 0;
  });
}

/// What the volumes say of a point, or nothing where they leave it open.
inline std::optional<Region> expected_region(const Light& light, const ShadowVolumes& volumes, const Point3& p) {
  const Side occlusion = volumes.occlusion.oriented_side(p);
  const Side umbra = volumes.umbra.oriented_side(p);
  if (!is_extended(light)) {
    return occlusion == Side::outside ? Region::lit : Region::umbra;  // closed: a grazing contact blocks
  }
  const auto* area = std::get_if<AreaLight>(&light);
  if (area && !area->polygon.is_flat()) {  // its fraction is that of triangles inside its hull
    if (occlusion == Side::outside) return Region::lit;
    return umbra == Side::inside ? std::optional(Region::umbra) : std::nullopt;
  }
  // A grazing contact hides nothing of an area light. Of a linear light it may, along a plane that holds all of it.
  const bool is_area = area != nullptr;
  if (occlusion == Side::outside || (is_area && occlusion == Side::boundary && umbra == Side::outside)) {
    return Region::lit;
  }
  if (umbra == Side::inside || (is_area && umbra == Side::boundary && occlusion == Side::inside)) return Region::umbra;
  if (occlusion == Side::inside && umbra == Side::outside) return Region::penumbra;
  return std::nullopt;
}

}  // namespace gnomon
