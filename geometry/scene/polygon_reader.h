#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A polygon of a scene file: convex and near a plane, or one that is taken as several convex parts.
using PolygonShape = std::variant<ConvexPolygon, ConcavePolygon>;

/// What becomes of a boundary that is not convex.
enum class ConcaveRing {
  accepted,
  refused,   ///< a polygon may have holes, but is convex around them
  of_light,  ///< accepted, but a convex boundary makes one polygon, also of rounded vertices
};

/// Reads "vertices" and "holes" of an element. Closed rings and equal neighbours are mended with a doubt, bent polygons
/// accepted with one.
///
/// Throws: SceneError.
PolygonShape read_polygon(const SceneElement& element, ConcaveRing concave, SpaceScene& scene);

/// A flat convex polygon of a name of its own.
struct NamedPolygon {
  std::string name;
  ConvexPolygon polygon;
};

/// The element as polygons that lights and receivers can be: itself, or parts `name#0`, `name#1`, ... without overlap,
/// each exactly flat.
std::vector<NamedPolygon> polygon_parts(const std::string& name, PolygonShape shape);

/// "1 triangle", "3 parts": how messages count.
std::string counted_words(std::size_t count, const std::string& noun);

}  // namespace gnomon
