#include "apps/proof/laws/search_cases.h"

#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/point_text.h"
#include "apps/proof/laws/visibility_cases.h"

namespace gnomon::laws {
namespace {

std::vector<Point3> vertices_of_all(const SearchCase& drawn) {
  std::vector<Point3> all{drawn.light.start, drawn.light.end};
  for (const ConvexBlocker& blocker : drawn.blockers) {
    std::visit([&](const auto& shape) { all.insert(all.end(), shape.points().begin(), shape.points().end()); },
               blocker);
  }
  return all;
}

Point3 draw_of(const std::vector<Point3>& points) {
  return points[std::size_t(draw(0, int(points.size()) - 1))];
}

/// A vertex, a point of the light's line, one behind a vertex as seen from the light, one in the plane of light and
/// vertex, or any.
Point3 draw_looking(const SearchCase& drawn, const std::vector<Point3>& vertices) {
  const Point3 vertex = draw_of(vertices);
  const Point3 lamp = between(drawn.light.start, draw(-1, 5) / 4.0, drawn.light.end);
  switch (draw(0, 5)) {
    case 0:
      return vertex;
    case 1:
      return lamp;
    case 2:
    case 3:
      return between(lamp, draw(-4, 12) / 4.0, vertex);
    case 4:
      return between(vertex, draw(-2, 4) / 2.0, draw_of(vertices));
    default:
      return draw_vector(6);
  }
}

SearchCase draw_search(Domain domain) {
  const int most = once_in(6) ? 40 : 6;
  const VisibilityCase base =
      *visibility_cases(domain, {{LightKind::segment}, {BlockerKind::polygon, BlockerKind::solid}, most});
  SearchCase drawn{std::get<LinearLight>(base.light), base.blockers, {base.point}, draw_vector(2)};
  if (drawn.normal == Point3{}) drawn.normal = {0, 0, 1};
  const std::vector<Point3> vertices = vertices_of_all(drawn);
  for (int i = draw(0, 6); i > 0; --i) drawn.points.push_back(draw_looking(drawn, vertices));
  return drawn;
}

}  // namespace

std::string description(const SearchCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  const Point3 ends[] = {drawn.light.start, drawn.light.end};
  write(out, "light", ends);
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const bool solid = std::holds_alternative<ConvexSolid>(blocker);
    std::visit([&](const auto& shape) { write(out, solid ? "solid" : "polygon", shape.points()); }, blocker);
  }
  write(out, "points", drawn.points);
  write(out, "normal", std::span(&drawn.normal, 1));
  return out.str();
}

const std::vector<LinearSearch>& searches() {
  using enum OccluderSearch;
  static const std::vector<LinearSearch> all = {{plane},           {hierarchy},         {grid, 1},
                                                {grid, 3},         {grid, 10},          {light_buffer, 1},
                                                {light_buffer, 7}, {light_buffer, 360}, {light_hierarchy}};
  return all;
}

rc::Gen<SearchCase> search_cases(Domain domain) {
  return rc::gen::exec([=] { return draw_search(domain); });
}

}  // namespace gnomon::laws
