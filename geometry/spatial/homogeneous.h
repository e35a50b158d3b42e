#pragma once

/// Planes and their meets in homogeneous coordinates, in whatever numbers: intervals, exact ones, double-double
/// numbers.

#include "geometry/spatial/exact_space.h"

namespace gnomon {

template <class Number>
std::array<Number, 3> cross(const Number& a, const Number& b, const Number& c, const Number& x, const Number& y,
                            const Number& z) {
  return {b * z - c * y, c * x - a * z, a * y - b * x};
}

/// The coefficients of the plane through three points, or two points and a direction.
template <class Number>
Quadruple<Number> point_coefficients(const std::array<Point3, 3>& points, bool along) {
  const auto& [p, q, r] = points;
  const Number x(p.x), y(p.y), z(p.z);
  const auto normal = cross<Number>(Number(q.x) - x, Number(q.y) - y, Number(q.z) - z,  //
                                    along ? Number(r.x) : Number(r.x) - x, along ? Number(r.y) : Number(r.y) - y,
                                    along ? Number(r.z) : Number(r.z) - z);
  return {normal[0], normal[1], normal[2], -(normal[0] * x + normal[1] * y + normal[2] * z)};
}

/// The coefficients of the plane (x - apex)_axis = bound * 2^(1000 scale) * (h(apex) - h(x)).
template <class Number>
Quadruple<Number> apex_coefficients(const PlaneDefinition& plane) {
  const Quadruple<Number> h = point_coefficients<Number>(plane.points, false);
  Number bound(plane.bound);
  for (int i = 0; i < plane.scale; ++i) bound = bound * Number(0x1p1000);
  for (int i = 0; i > plane.scale; --i) bound = bound * Number(0x1p-1000);
  const std::array<Number, 3> apex = {Number(plane.apex.x), Number(plane.apex.y), Number(plane.apex.z)};
  Quadruple<Number> result{bound * h[0], bound * h[1], bound * h[2], Number(0)};
  result[plane.axis] = result[plane.axis] + Number(1);
  // It goes through the apex.
  result[3] = -(result[0] * apex[0] + result[1] * apex[1] + result[2] * apex[2]);
  return result;
}

/// The coefficients of a plane.
template <class Number>
Quadruple<Number> coefficients(const PlaneDefinition& plane) {
  using enum PlaneDefinition::Kind;
  Quadruple<Number> result{Number(0), Number(0), Number(0), Number(0)};
  if (plane.kind == infinity) {
    result[3] = Number(1);
    return result;
  }
  if (plane.kind == PlaneDefinition::Kind::axis) {
    result[plane.axis] = Number(plane.sign);
    result[3] = Number(-plane.sign) * Number(plane.bound);
    return result;
  }
  result = plane.kind == PlaneDefinition::Kind::apex
               ? apex_coefficients<Number>(plane)
               : point_coefficients<Number>(plane.points, plane.kind == points_direction);
  if (plane.sign > 0) return result;
  return {-result[0], -result[1], -result[2], -result[3]};
}

template <class Number>
Quadruple<Number> input_coordinates(const InputVertex& input) {
  const Point3& a = input.first;
  const Point3& b = input.second;
  if (input.kind == InputVertex::Kind::difference) {
    return {Number(b.x) - Number(a.x), Number(b.y) - Number(a.y), Number(b.z) - Number(a.z), Number(0)};
  }
  return {Number(a.x), Number(a.y), Number(a.z), Number(input.kind == InputVertex::Kind::point ? 1 : 0)};
}

template <class Number>
Number value(const Quadruple<Number>& plane, const Quadruple<Number>& point) {
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

/// A plane with its coefficients, for meets.
template <class Number>
struct PlaneWithNumbers {
  const PlaneDefinition* definition;
  const Quadruple<Number>* numbers;
};

/// The point in which a plane meets the line through the end of an input direction, up to sign.
template <class Number>
Quadruple<Number> line_meet(const InputVertex& line, const PlaneWithNumbers<Number>& plane) {
  const Quadruple<Number> along = input_coordinates<Number>(line);
  const Point3& p = line.second;
  const Quadruple<Number> end{Number(p.x), Number(p.y), Number(p.z), Number(1)};
  if (plane.definition->kind == PlaneDefinition::Kind::axis) {
    const std::uint32_t i = plane.definition->axis;
    const Number rest = Number(plane.definition->bound) - end[i];
    Quadruple<Number> result;
    for (std::uint32_t k = 0; k < 3; ++k) result[k] = end[k] * along[i] + along[k] * rest;
    result[i] = Number(plane.definition->bound) * along[i];
    result[3] = along[i];
    return result;
  }
  const Quadruple<Number>& c = *plane.numbers;
  const Number slope = c[0] * along[0] + c[1] * along[1] + c[2] * along[2];
  const Number height = value(c, end);
  return {end[0] * slope - along[0] * height, end[1] * slope - along[1] * height, end[2] * slope - along[2] * height,
          slope};
}

/// The point on three planes, up to sign.
template <class Number>
Quadruple<Number> general_meet(const Quadruple<Number>& p, const Quadruple<Number>& q, const Quadruple<Number>& r) {
  const Number xy = q[0] * r[1] - q[1] * r[0], xz = q[0] * r[2] - q[2] * r[0], xw = q[0] * r[3] - q[3] * r[0];
  const Number yz = q[1] * r[2] - q[2] * r[1], yw = q[1] * r[3] - q[3] * r[1], zw = q[2] * r[3] - q[3] * r[2];
  return {p[1] * zw - p[2] * yw + p[3] * yz, p[2] * xw - p[0] * zw - p[3] * xz, p[0] * yw - p[1] * xw + p[3] * xy,
          p[1] * xz - p[0] * yz - p[2] * xy};
}

/// The point in which a plane at right angles to an axis (or the one at infinity) meets two other planes.
template <class Number>
Quadruple<Number> special_meet(const PlaneDefinition& special, const Quadruple<Number>& q, const Quadruple<Number>& r) {
  if (special.kind == PlaneDefinition::Kind::infinity) {
    const auto [x, y, z] = cross<Number>(q[0], q[1], q[2], r[0], r[1], r[2]);
    return {x, y, z, Number(0)};
  }
  const std::uint32_t i = special.axis, j = (i + 1) % 3, k = (i + 2) % 3;
  const Number bound(special.bound);
  const auto reduced = cross<Number>(q[j], q[k], q[3] + q[i] * bound, r[j], r[k], r[3] + r[i] * bound);
  Quadruple<Number> result;
  result[i] = bound * reduced[2];
  result[j] = reduced[0];
  result[k] = reduced[1];
  result[3] = reduced[2];
  return result;
}

/// The point on three planes, up to sign; cheaper where one of them is at right angles to an axis or at infinity.
template <class Number>
Quadruple<Number> meet(const PlaneWithNumbers<Number>& p, const PlaneWithNumbers<Number>& q,
                       const PlaneWithNumbers<Number>& r) {
  const auto is_special = [](const PlaneWithNumbers<Number>& plane) {
    return plane.definition->kind == PlaneDefinition::Kind::axis ||
           plane.definition->kind == PlaneDefinition::Kind::infinity;
  };
  if (is_special(r)) return special_meet(*r.definition, *p.numbers, *q.numbers);
  if (is_special(q)) return special_meet(*q.definition, *p.numbers, *r.numbers);
  if (is_special(p)) return special_meet(*p.definition, *q.numbers, *r.numbers);
  return general_meet(*p.numbers, *q.numbers, *r.numbers);
}

}  // namespace gnomon
