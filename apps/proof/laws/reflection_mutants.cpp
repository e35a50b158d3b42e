#include "apps/proof/laws/law_lists.h"

#include <utility>

#include "apps/proof/laws/reflection_cases.h"

namespace gnomon::laws {
namespace {

using Keys = std::vector<std::string>;

/// What is asked of a light.
struct Question {
  Light light;
  Obstacles obstacles;
  gnomon::View view;
  ReflectionModel model;
  int exponent;

  Reflection answer() const { return LightReflection(light, PreparedObstacles(obstacles)).at(view, model, exponent); }
};

Mutant reflected(std::string name, std::string does, Keys caught_by, Reflection (*broken)(Question)) {
  Mutant mutant{std::move(name), std::move(does), Part::reflection, {}, std::move(caught_by)};
  mutant.subject.reflection = [broken](const Light& light, const Obstacles& obstacles, const gnomon::View& view,
                                       ReflectionModel model, int exponent) {
    return broken({light, obstacles, view, model, exponent});
  };
  return mutant;
}

bool has_size(const Light& light) {
  return std::holds_alternative<LinearLight>(light) || std::holds_alternative<AreaLight>(light);
}

}  // namespace

std::vector<Mutant> reflection_mutants() {
  return {
      reflected("clip_first_vertex", "the eighth of a light next to its first vertex cut off", {"H1", "H2"},
                [](Question q) {
                  if (has_size(q.light)) {
                    std::vector<Point3> p = corners_of(q.light);
                    const Point3 &a = p[0], &b = p[1];
                    p[0] = {a.x + (b.x - a.x) / 8, a.y + (b.y - a.y) / 8, a.z + (b.z - a.z) / 8};
                    if (p.size() == 2 || !ConvexPolygon::defect(p)) q.light = with_points(q.light, p);
                  }
                  return q.answer();
                }),
      reflected("normal_up", "the normal taken for z", {"H3"},
                [](Question q) {
                  q.view.normal = {0, 0, 1};
                  return q.answer();
                }),
      reflected("falls_with_square", "a linear light taken to fall with the square of distance", {"H4", "G1"},
                [](Question q) {
                  Reflection r = q.answer();
                  if (!std::holds_alternative<LinearLight>(q.light)) return r;
                  const std::vector<Point3> p = corners_of(q.light);
                  const double x = p[0].x - q.view.point.x, y = p[0].y - q.view.point.y, z = p[0].z - q.view.point.z;
                  const double closer = 1 / (1 + x * x + y * y + z * z);
                  for (Irradiance* e : {&r.received, &r.lobe}) *e = {closer * e->value, closer * e->error_bound};
                  return r;
                }),
      reflected("no_cosine", "phong and blinn without their cosine", {"H5", "H6"},
                [](Question q) {
                  if (q.model == ReflectionModel::phong) q.model = ReflectionModel::phong_classic;
                  if (q.model == ReflectionModel::blinn) q.model = ReflectionModel::blinn_classic;
                  return q.answer();
                }),
      reflected("half_exponent", "even exponents halved", {"H7", "G4"},
                [](Question q) {
                  if (q.exponent % 2 == 0) q.exponent /= 2;
                  return q.answer();
                }),
      reflected("bright_blockers", "light added for each blocker", {"H8"},
                [](Question q) {
                  Reflection r = q.answer();
                  r.received.value += 1e-3 * double(q.obstacles.blockers.size()) * (1 + r.received.value);
                  return r;
                }),
      reflected("thin_bounds", "values rounded to floats within the old bounds", {"H1"},
                [](Question q) {
                  Reflection r = q.answer();
                  for (Irradiance* e : {&r.received, &r.lobe}) e->value = static_cast<float>(e->value);
                  return r;
                }),
  };
}

}  // namespace gnomon::laws
