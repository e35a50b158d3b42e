#include "geometry/spatial/vertex_rounding.h"

#include "geometry/numbers/rounding.h"

namespace gnomon {

ExactVector exact_coordinates(const ExactSpace& space, VertexId vertex) {
  const Quadruple<ExactReal>& v = space.exact_vertex(vertex);
  const Rational w = rational(v[3]);
  return {Rational(rational(v[0]) / w), Rational(rational(v[1]) / w), Rational(rational(v[2]) / w)};
}

const DoubleDoublePlane& VertexRounding::double_double(PlaneId plane) {
  if (!planes_[plane]) planes_[plane].emplace(space_.definition(plane));
  return *planes_[plane];
}

Point3 VertexRounding::operator()(VertexId vertex) {
  const VertexDefinition& definition = space_.vertex_definition(vertex);
  if (definition.input != VertexDefinition::none) return space_.input(definition.input).first;
  if (!definition.middle) {
    const auto& [a, b, c] = definition.planes;
    if (const auto found =
            CommonPoint(double_double(a), double_double(b), double_double(c)).rounded(space_.nearby_point(vertex)))
      return *found;
  }
  const ExactVector exact = exact_coordinates(space_, vertex);
  return {nearest_double(exact[0]), nearest_double(exact[1]), nearest_double(exact[2])};
}

}  // namespace gnomon
