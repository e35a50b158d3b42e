#include "geometry/spatial/pair_form.h"

#include <algorithm>

#include "geometry/spatial/light_contact.h"
#include "geometry/spatial/pair_sides.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

bool is_flat(const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  return !area || area->polygon.is_flat();
}

Position directional_position(const BodyPair& pair) {
  return pair.blocker.flat && pair.facet_side(0, 0) == 0 ? Position::coplanar : Position::standard;
}

/// On which sides of the light's plane the blocker lies; in front of a light that is not flat and not behind all of it.
Sides blocker_sides(const BodyPair& pair) {
  Sides result;
  for (const Point3& corner : pair.blocker.corners) {
    Sides of_corner;
    for (std::uint32_t f = 0; f < (pair.light.flat ? 1 : pair.light.facets.size()); ++f) {
      of_corner.add(pair.orientation(pair.light.facet_point(f, 0), pair.light.facet_point(f, 1),
                                     pair.light.facet_point(f, 2), corner));
    }
    result.add(of_corner.positive ? 1 : of_corner.zero ? 0 : -1);
  }
  return result;
}

Position body_position(const BodyPair& pair, bool one_sided) {
  const bool has_area = pair.light.corners.size() > 2;
  const Sides of_blocker = has_area ? blocker_sides(pair) : Sides{};
  if (has_area && pair.light.flat && one_sided && !of_blocker.positive) return Position::behind_light;
  Sides of_light;
  if (pair.blocker.flat) {
    of_light = pair.light_sides(0);
    if (of_light.all_zero()) return Position::coplanar;
  } else {
    const LightContact contact = light_contact(pair);
    if (contact.meets_interior) of_light = {true, true, true};
    of_light.zero = contact.meets;
  }
  if (of_light.cross() && of_blocker.cross()) return Position::both_cross;
  if (of_light.cross()) return Position::light_crosses_blocker_plane;
  if (of_blocker.cross()) return Position::blocker_crosses_light_plane;
  return of_light.zero || of_blocker.zero ? Position::touching : Position::standard;
}

/// True if the plane of a facet of one holds the two strictly apart.
bool stand_apart(const BodyPair& pair) {
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    if (pair.light_sides(f).all_positive()) return true;
  }
  for (std::uint32_t f = 0; f < pair.light.facets.size(); ++f) {
    if (pair.blocker_sides(f).all_positive()) return true;
  }
  return false;
}

/// True if the blocker lies strictly in front of every triangle of the fan from a light's first vertex, by which such a
/// light is lit and unlit.
bool is_in_front(const BodyPair& pair, const ConvexPolygon& light) {
  const std::span<const Point3> points = light.points();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    for (const Point3& corner : pair.blocker.corners) {
      if (exact_orientation(points[0], points[i], points[i + 1], corner) <= 0) return false;
    }
  }
  return true;
}

}  // namespace

std::string_view name(Position position) {
  constexpr std::string_view names[] = {
      "standard",    "light_crosses_blocker_plane", "blocker_crosses_light_plane", "both_cross", "touching", "coplanar",
      "behind_light"};
  return names[static_cast<int>(position)];
}

PairForm::PairForm(const Light& light, const ConvexBlocker& blocker) : light_(&light), blocker_(&blocker) {
  const auto* polygon = std::get_if<ConvexPolygon>(&blocker);
  if (!polygon || !polygon->is_flat() || !is_flat(light) || std::holds_alternative<DirectionalLight>(light)) return;
  const PairSides sides = pair_sides(light, *polygon);
  position_ = pair_position(light, sides);
  if (*position_ == Position::standard) standard_ = standard_pair(light, *polygon, sides);
}

BodyPair& PairForm::bodies() {
  if (!bodies_) bodies_.emplace(body(*light_), body(*blocker_));
  return *bodies_;
}

Position PairForm::position() {
  if (position_) return *position_;
  const auto* area = std::get_if<AreaLight>(light_);
  position_ = std::holds_alternative<DirectionalLight>(*light_) ? directional_position(bodies())
                                                                : body_position(bodies(), area && !area->two_sided);
  return *position_;
}

std::string_view PairForm::refusal() {
  if (is_flat(*light_)) return {};
  const auto& area = std::get<AreaLight>(*light_);
  if (stand_apart(bodies()) && (area.two_sided || is_in_front(bodies(), area.polygon))) return {};
  return "the light's vertices are not exactly coplanar, so the blocker has to lie strictly apart from it, and "
         "strictly "
         "in front if it is one-sided";
}

void PairForm::require_support() {
  if (!refusal().empty()) throw PreconditionError(std::string(refusal()));
}

Position pair_position(const Light& light, const ConvexBlocker& blocker) {
  return PairForm(light, blocker).position();
}

std::string_view pair_refusal(const Light& light, const ConvexBlocker& blocker) {
  return is_flat(light) ? "" : PairForm(light, blocker).refusal();
}

}  // namespace gnomon
