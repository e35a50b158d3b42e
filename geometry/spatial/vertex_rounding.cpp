#include "geometry/spatial/vertex_rounding.h"

#include "geometry/rounding.h"
#include "geometry/spatial/homogeneous.h"

namespace gnomon {
namespace {

constexpr std::uint32_t none = VertexDefinition::none;

Rational rational(const ExactReal& number) {
  Rational result;
  number.export_to_mpq_t(result.backend().data());
  return result;
}

}  // namespace

std::array<Rational, 3> exact_coordinates(const ExactSpace& space, VertexId vertex) {
  const Quadruple<ExactReal>& v = space.exact_vertex(vertex);
  const Rational w = rational(v[3]);
  return {Rational(rational(v[0]) / w), Rational(rational(v[1]) / w), Rational(rational(v[2]) / w)};
}

const Quadruple<DoubleDouble>& VertexRounding::numbers(PlaneId plane) {
  if (!planes_[plane]) planes_[plane] = coefficients<DoubleDouble>(space_.definition(plane));
  return *planes_[plane];
}

Quadruple<DoubleDouble> VertexRounding::coordinates(const VertexDefinition& vertex) {
  const auto with_numbers = [&](PlaneId p) {
    return PlaneWithNumbers<DoubleDouble>{&space_.definition(p), &numbers(p)};
  };
  const auto& [a, b, c] = vertex.planes;
  if (vertex.line == none) return meet<DoubleDouble>(with_numbers(a), with_numbers(b), with_numbers(c));
  if (space_.definition(c).kind != PlaneDefinition::Kind::axis) {
    return line_meet<DoubleDouble>(space_.input(vertex.line), with_numbers(c));
  }
  return line_meet<DoubleDouble>(space_.input(vertex.line), {&space_.definition(c), nullptr});
}

Point3 VertexRounding::operator()(VertexId vertex) {
  const VertexDefinition& definition = space_.vertex_definition(vertex);
  if (definition.input != none) return space_.input(definition.input).first;
  if (definition.middle) {
    const std::array<Rational, 3> middle = exact_coordinates(space_, vertex);
    return {nearest_double(middle[0]), nearest_double(middle[1]), nearest_double(middle[2])};
  }
  const Quadruple<DoubleDouble> v = coordinates(definition);
  std::array<double, 3> rounded;
  std::optional<std::array<Rational, 3>> exact;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble quotient = v[i] / v[3];
    if (quotient.rounds_to_high()) {
      rounded[i] = quotient.high();
    } else {
      if (!exact) exact = exact_coordinates(space_, vertex);
      rounded[i] = nearest_double((*exact)[i]);
    }
  }
  return {rounded[0], rounded[1], rounded[2]};
}

}  // namespace gnomon
