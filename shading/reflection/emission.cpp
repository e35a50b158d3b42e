#include "shading/reflection/emission.h"

#include "shading/reflection/reflection_query.h"

namespace gnomon::shading {
namespace {

Vector3<Bounded> difference(const Point3& a, const Point3& b) {
  const Vector d{a.x - b.x, a.y - b.y, a.z - b.z};
  return {{d.x, unit * std::fabs(d.x)}, {d.y, unit * std::fabs(d.y)}, {d.z, unit * std::fabs(d.z)}};
}

Vector3<Bounded> vector(const Point3& p) {
  return {p.x, p.y, p.z};
}

/// 2 where doubles do not decide, also where they may have underflown.
int quick_turn(const Vector3<Bounded>& axis, const Vector3<Bounded>& a, const Vector3<Bounded>& b) {
  const Bounded volume = dot(axis, cross(a, b));
  return std::fabs(volume.value) > 1e-200 ? certain_sign(volume) : 2;
}

int exact_turn(const ExactVector& axis, const ExactVector& a, const ExactVector& b) {
  return dot(axis, cross(a, b)).sign();
}

/// 1 if turning right-handed about the axis from `from` by less than half a turn one meets p, -1 by more, else 0.
int turn_to(const LinearLight& light, const Point3& from, const Point3& p) {
  const int quick = quick_turn(difference(light.end, light.start), vector(from), difference(p, light.start));
  if (quick != 2) return quick;
  return exact_turn(exact(light.end) - exact(light.start), exact(from), exact(p) - exact(light.start));
}

}  // namespace

bool is_shone_at(const LinearLight& light, const Point3& p) {
  if (!light.emission.shade) return true;
  const auto& [from, to] = *light.emission.shade;
  const int opening = exact_turn(exact(light.end) - exact(light.start), exact(from), exact(to));
  const bool after = turn_to(light, from, p) >= 0, before = turn_to(light, to, p) <= 0;
  if (opening == 0) return after;  // half a turn
  return opening > 0 ? after && before : after || before;
}

}  // namespace gnomon::shading
