#include "shading/image/facet_shading.h"

#include <algorithm>
#include <cmath>

#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/prepared_obstacles.h"
#include "shading/image/scene_radiance.h"
#include "shading/receiver_grid.h"
#include "shading/reflection/reflection_query.h"

namespace gnomon::image {
namespace {

using shading::Bounded;

Point3 opposite_of(const Point3& p) {
  return {-p.x, -p.y, -p.z};
}

Point3 facet_normal(const FacetSide& side) {
  return side.is_front ? side.facet->normal : opposite_of(side.facet->normal);
}

Point3 corner_normal(const FacetSide& side, std::size_t corner) {
  if (side.facet->vertex_normals.empty()) return facet_normal(side);
  const Point3& n = side.facet->vertex_normals[corner];
  return side.is_front ? n : opposite_of(n);
}

FacetFront front_of(const FacetSide& side) {
  FacetFront front = facet_front(side.facet->shape);
  if (!side.is_front) std::swap(front.corners[1], front.corners[2]);
  return front;
}

/// True if nothing but the part that a facet bounds comes near a place.
bool is_alone(const ShadedScene& scene, const FacetSide& side, const Point3& place) {
  std::vector<std::uint32_t> near;
  scene.obstacles.content().blockers.content().collect_near(place, near);
  return std::ranges::all_of(near, [&](std::uint32_t blocker) { return side.facet->blocker == blocker; });
}

/// On the facet, which hides nothing from its own points; nor does what else they rest on.
ReceiverPoint point_on(const ShadedScene& scene, const FacetSide& side, const Point3& place) {
  ReceiverPoint receiver{place, front_of(side)};
  const auto& own = side.facet->blocker;
  if (!is_alone(scene, side, place)) receiver.under = resting_point(scene.obstacles, place, facet_normal(side)).under;
  const auto at = std::ranges::lower_bound(receiver.under, own.value_or(0));
  if (own && (at == receiver.under.end() || *at != *own)) receiver.under.insert(at, *own);
  return receiver;
}

/// Half of the way to the eye, which does not overflow.
Point3 half_way(const Point3& from, const Point3& to) {
  return {to.x / 2 - from.x / 2, to.y / 2 - from.y / 2, to.z / 2 - from.z / 2};
}

/// A share of a value with its bound; an infinite one stays infinite.
Bounded share_of_value(double share, double value, double error_bound) {
  if (!(error_bound < HUGE_VAL)) return share == 0 ? Bounded(0.0) : Bounded(HUGE_VAL, HUGE_VAL);
  return Bounded(share) * Bounded(value, error_bound);
}

Irradiance with_bound(const Bounded& sum) {
  if (shading::is_exact_zero(sum)) return {};
  return {sum.value, shading::with_underflow(1.01 * sum.error)};
}

Irradiance times(const Irradiance& e, double strength) {
  return with_bound(share_of_value(strength, e.value, e.error_bound));
}

/// A sum of what is known at the corners of a triangle, with weights.
Shaded interpolated(const std::vector<Shaded>& corners, const Hit& hit) {
  const std::array<std::size_t, 3> numbers{0, hit.triangle + 1, hit.triangle + 2};
  std::array<Bounded, 3> radiance;
  Bounded irradiance;
  for (std::size_t k = 0; k < 3; ++k) {
    const Shaded& corner = corners[numbers[k]];
    for (std::size_t c = 0; c < 3; ++c) {
      const Radiance& r = corner.radiance[c];
      radiance[c] = radiance[c] + share_of_value(hit.shares[k], r.value, r.error_bound);
    }
    irradiance = irradiance + share_of_value(hit.shares[k], corner.irradiance.value, corner.irradiance.error_bound);
  }
  Shaded result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Irradiance sum = with_bound(radiance[c]);
    result.radiance[c] = {sum.value, sum.error_bound};
  }
  result.irradiance = with_bound(irradiance);
  return result;
}

Point3 interpolated_normal(const FacetSide& side, const Hit& hit) {
  if (side.facet->vertex_normals.empty()) return facet_normal(side);
  const std::array<std::size_t, 3> numbers{0, hit.triangle + 1, hit.triangle + 2};
  Point3 sum{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 n = corner_normal(side, numbers[k]);
    const double share = hit.shares[k];
    sum = {sum.x + share * n.x, sum.y + share * n.y, sum.z + share * n.z};
  }
  return sum == Point3{} ? facet_normal(side) : sum;
}

}  // namespace

Shaded shaded_place(const ShadedScene& scene, WorkersLights& lights, const FacetSide& side, const Point3& place,
                    const Point3& normal) {
  const Material& material = *side.facet->material;
  View view{place, normal, half_way(place, scene.eye)};
  Material seen = material;
  if (!eye_is_above(view)) {
    view.to_eye = normal;
    seen.specular = {0, 0, 0};
  }
  const ReceiverPoint receiver = point_on(scene, side, place);
  const LengthUnit unit = *length_unit_named(scene.scene.length_unit);
  std::vector<RadianceRgb> parts;
  std::vector<Irradiance> irradiances;
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const SceneLight& light = *scene.lights[l];
    const Reflection r = lights[l].received(receiver, view, seen.model, seen.exponent);
    parts.push_back(reflected_radiance(light, r, seen, unit));
    irradiances.push_back(times(per_square_metre(r.received, light.shape, unit), light.strength));
  }
  parts.push_back(ambient_radiance(material, scene.scene.ambient_radiance));
  return {total_radiance(parts), total_irradiance(irradiances)};
}

struct FacetShading::Kept {
  std::once_flag once;
  std::vector<Shaded> shaded;
};

FacetShading::FacetShading(const ShadedScene& scene, std::span<const Facet> facets, ShadingMode mode)
    : scene_(scene), facets_(facets), mode_(mode), kept_(mode == ShadingMode::phong ? 0 : 2 * facets.size()) {}
FacetShading::~FacetShading() = default;

std::vector<Shaded> FacetShading::corners(const FacetSide& side, WorkersLights& lights) const {
  if (mode_ == ShadingMode::flat) {
    return {shaded_place(scene_, lights, side, mean_of_corners(side.facet->shape), facet_normal(side))};
  }
  std::vector<Shaded> result;
  const auto& points = side.facet->shape.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    result.push_back(shaded_place(scene_, lights, side, points[k], corner_normal(side, k)));
  }
  return result;
}

const std::vector<Shaded>& FacetShading::kept(const Hit& hit, WorkersLights& lights) {
  Kept& kept = kept_[2 * hit.facet + (hit.is_front ? 0 : 1)];
  std::call_once(kept.once, [&] { kept.shaded = corners({&facets_[hit.facet], hit.is_front}, lights); });
  return kept.shaded;
}

Shaded FacetShading::at(const Hit& hit, WorkersLights& lights) {
  if (mode_ == ShadingMode::flat) return kept(hit, lights).front();
  if (mode_ == ShadingMode::gouraud) return interpolated(kept(hit, lights), hit);
  const FacetSide side{&facets_[hit.facet], hit.is_front};
  return shaded_place(scene_, lights, side, hit.place, interpolated_normal(side, hit));
}

}  // namespace gnomon::image
