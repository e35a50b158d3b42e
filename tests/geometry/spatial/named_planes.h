#pragma once

/// The half-spaces of a pair told by the points they go through, not by indices: so two numberings of one pair, or a
/// pair and its image, can be compared.

#include <cstdint>
#include <optional>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

/// A bounding plane: its kind, all points on the line of its edge, and all points of the other body on it but not on
/// that line. A plane of a facet has no edge and the points of its own body. Points are sorted.
struct NamedPlane {
  FacetKind kind{};
  std::vector<Point3> edge;
  std::vector<Point3> touching;

  friend bool operator==(const NamedPlane&, const NamedPlane&) = default;
};

/// The points of a light, of a directional one its direction.
std::vector<Point3> points_of(const Light& light);
std::vector<Point3> points_of(const ConvexBlocker& blocker);

/// Lexicographic order.
bool is_before(const Point3& a, const Point3& b);
bool is_before(const NamedPlane& a, const NamedPlane& b);
/// Each point once, in lexicographic order.
void sort_distinct(std::vector<Point3>& points);

/// What a half-space goes through, found with exact signs.
NamedPlane named_plane(const Light& light, const ConvexBlocker& blocker, const HalfSpace& half_space);

bool is_same_plane(const HalfSpace& a, const HalfSpace& b);

/// True if a name stands for the lowest indices among what the half-space goes through: the edge of lowest index on the
/// line, the vertex of lowest index on the plane and off the line. An edge of a rounded light is named alone, a
/// diagonal of its hull not at all (-1).
bool names_lowest(const Light& light, const ConvexBlocker& blocker, const HalfSpace& half_space);

}  // namespace gnomon
