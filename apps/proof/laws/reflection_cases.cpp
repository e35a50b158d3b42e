#include "apps/proof/laws/reflection_cases.h"

#include <cmath>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/point_text.h"

namespace gnomon::laws {
namespace {

Point3 sum(const Point3& a, double s, const Point3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

double product(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Light drawn_line() {
  for (;;) {
    const LinearLight light{draw_vector(4), draw_vector(4)};
    if (!(light.start == light.end)) return light;
  }
}

Light drawn_lamp() {
  for (;;) {
    const Point3 a = draw_vector(4), b = draw_vector(4), c = draw_vector(4);
    std::vector<Point3> corners = {a, b, c};
    if (once_in(2)) corners = {a, b, sum(b, 1, sum(c, -1, a)), c};
    if (!ConvexPolygon::defect(corners)) return AreaLight{ConvexPolygon::from_points(corners), true};
  }
}

constexpr std::array models = {ReflectionModel::phong, ReflectionModel::blinn, ReflectionModel::phong_classic,
                               ReflectionModel::blinn_classic};

int drawn_exponent(Domain domain) {
  constexpr std::array usual = {0, 1, 2, 3, 5, 10, 20, 50};
  constexpr std::array far = {0, 1, 64, 200, 1000, 9999};
  return domain == Domain::random ? usual[std::size_t(draw(0, 7))] : far[std::size_t(draw(0, 5))];
}

/// An eye that sees the first end mirrored, or anything else.
Point3 drawn_eye(const Point3& towards, const Point3& n) {
  const Point3 eye =
      once_in(2) ? draw_vector(3) : sum(sum({0, 0, 0}, -product(n, n), towards), 2 * product(towards, n), n);
  return product(eye, n) > 0 ? eye : sum(eye, 1 - product(eye, n), n);
}

void bend(ReflectionCase& drawn) {
  Point3& p = drawn.view.point;
  const double aside = once_in(2) ? 9 : -9;
  if (once_in(2)) p.z = p.z == 0 ? aside * 0x1p-55 : std::nextafter(p.z, aside);
  const double size = std::ldexp(1, draw(-30, 30));
  const auto scaled = [size](const Point3& q) { return Point3{size * q.x, size * q.y, size * q.z}; };
  p = scaled(p);
  std::vector<Point3> points = corners_of(drawn.light);
  for (Point3& q : points) q = scaled(q);
  drawn.light = with_points(drawn.light, points);
  if (once_in(4)) drawn.view.to_eye = sum(drawn.view.to_eye, 1e-9, drawn.view.normal);
}

ReflectionCase drawn_case(Domain domain, const Light& light) {
  ReflectionCase drawn{light, {}, {}, models[std::size_t(draw(0, 3))], drawn_exponent(domain), draw(1, 7) / 8.0};
  drawn.view.point = {double(draw(-2, 2)), double(draw(-2, 2)), double(draw(-4, 0))};
  drawn.view.normal = once_in(2) ? Point3{0, 0, 1} : sum(draw_vector(2), 1, {0, 0, 3});
  drawn.view.to_eye = drawn_eye(sum(corners_of(light)[0], -1, drawn.view.point), drawn.view.normal);
  if (domain == Domain::near_degenerate) bend(drawn);
  const bool is_halfway = drawn.model == ReflectionModel::blinn || drawn.model == ReflectionModel::blinn_classic;
  if (is_halfway && drawn.exponent > 64) drawn.exponent = 64;  // for the sake of time
  return drawn;
}

}  // namespace

std::vector<Point3> corners_of(const Light& light) {
  if (const auto* line = std::get_if<LinearLight>(&light)) return {line->start, line->end};
  const auto& points = std::get<AreaLight>(light).polygon.points();
  return {points.begin(), points.end()};
}

Light with_points(const Light& light, std::vector<Point3> points) {
  if (const auto* line = std::get_if<LinearLight>(&light)) return LinearLight{points[0], points[1], line->emission};
  return AreaLight{ConvexPolygon::from_points(std::move(points)), true};
}

std::string description(const ReflectionCase& drawn) {
  std::ostringstream out;
  out.precision(17);
  write(out, "light", corners_of(drawn.light));
  for (const ConvexBlocker& blocker : drawn.blockers) write(out, "blocker", std::get<ConvexPolygon>(blocker).points());
  const std::array points{drawn.view.point, drawn.view.normal, drawn.view.to_eye};
  write(out, "point, normal, way to the eye", points);
  out << "model " << int(drawn.model) << ", exponent " << drawn.exponent << ", cut at " << drawn.share << '\n';
  return out.str();
}

Example example(const ReflectionCase& drawn) {
  return spatial_example(drawn.light, drawn.blockers, {drawn.view.point});
}

rc::Gen<ReflectionCase> reflection_cases(Domain domain) {
  return rc::gen::exec([domain] { return drawn_case(domain, once_in(2) ? drawn_line() : drawn_lamp()); });
}

rc::Gen<ReflectionCase> linear_cases(Domain domain) {
  return rc::gen::exec([domain] { return drawn_case(domain, drawn_line()); });
}

}  // namespace gnomon::laws
