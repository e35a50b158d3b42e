#pragma once

/// What a picture of a scene shows: flat convex facets in triangles. Private to the libraries.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon::image {

/// A flat convex piece of a blocker or a receiver, or an area light.
struct Facet {
  ConvexPolygon shape;
  Point3 normal;                         ///< of unit length, to the front; rounded
  std::vector<Point3> vertex_normals;    ///< one a corner, of unit length; none: the facet's own everywhere
  std::uint32_t element = 0;             ///< index of Surfaces::elements
  std::uint32_t number = 0;              ///< of the facet in its element, from 0
  std::optional<std::uint32_t> blocker;  ///< index of the part among the obstacles that it bounds
  const Material* material = nullptr;    ///< none of a light
  const SceneLight* light = nullptr;     ///< none of a surface
};

/// The facets of a scene: blockers, receivers (those of two sides once), lights that are polygons.
struct Surfaces {
  std::vector<std::string> elements;  ///< names, in that order
  std::size_t lights_from = 0;        ///< the number of elements that are no lights
  std::size_t flattened = 0;          ///< facets that stayed flat because normals at a corner cancel
  std::vector<Facet> facets;          ///< by element and number, ascending
};

/// Exactness: facets are the scene's own, so what is not exactly flat is a fan of triangles.
/// Requires: a scene that outlives the result.
Surfaces surfaces_of(const SpaceScene& scene);

}  // namespace gnomon::image
