#include "apps/proof/laws/law_lists.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/reflection_cases.h"

namespace gnomon::laws {
namespace {

constexpr double pi = std::numbers::pi;

using V = std::array<double, 3>;

V difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double inner(const V& a, const V& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double size(const V& a) {
  return std::sqrt(inner(a, a));
}

/// A linear light above a point that faces up, and an eye above it.
ReflectionCase tube_case(const Point3& a, const Point3& b, const Point3& eye, int n) {
  return {LinearLight{a, b}, {}, {{0, 0, 0}, {0, 0, 1}, eye}, ReflectionModel::phong_classic, n};
}

rc::Gen<ReflectionCase> tubes(Domain domain) {
  return rc::gen::exec([domain] {
    const double scale = domain == Domain::random ? 1 : std::ldexp(1, draw(-20, 20));
    const auto end = [&] {
      const double x = draw(-4, 4), y = draw(-4, 4);
      return Point3{scale * x, scale * y, scale * draw(1, 5)};
    };
    Point3 a = end(), b = end();
    if (a == b) b.z += scale;
    const double x = draw(-3, 3), y = draw(-3, 3);
    return tube_case(a, b, {x, y, double(draw(1, 4))}, draw(1, 64));
  });
}

/// The integral of f(direction) / r² along the light, by the rule of midpoints: near enough to see what is false.
double along_light(const ReflectionCase& drawn, const std::function<double(const V&)>& f) {
  const auto& light = std::get<LinearLight>(drawn.light);
  const V from = difference(light.start, drawn.view.point), along = difference(light.end, light.start);
  constexpr int steps = 4000;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = (k + 0.5) / steps;
    const V x{from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2]};
    const double r = size(x);
    sum += f({x[0] / r, x[1] / r, x[2] / r}) / (r * r);
  }
  return sum * size(along) / steps;
}

bool is_close(double a, double b) {
  return std::fabs(a - b) <= 1e-4 * std::fmax(std::fabs(a), std::fabs(b)) + 1e-12;
}

/// [PA90] §3: the antiderivative of (a + b t) / (C t² + D t + F)^(3/2) between 0 and 1, without the length of the way.
double printed_diffuse(const ReflectionCase& drawn) {
  const auto& light = std::get<LinearLight>(drawn.light);
  const V x = difference(light.start, drawn.view.point), v = difference(light.end, light.start);
  const double a = x[2], b = v[2], c = inner(v, v), d = 2 * inner(x, v), f = inner(x, x);
  const auto at = [&](double t) {
    return (2 * a * (2 * c * t + d) - 2 * b * (d * t + 2 * f)) /
           ((4 * c * f - d * d) * std::sqrt(c * t * t + d * t + f));
  };
  return at(1) - at(0);
}

Verdict check_printed_diffuse(const ReflectionCase& drawn, const Subject& subject) {
  const auto& light = std::get<LinearLight>(drawn.light);
  const V x = difference(light.start, drawn.view.point), v = difference(light.end, light.start);
  if (inner(x, x) * inner(v, v) - inner(x, v) * inner(x, v) < 1e-6 * inner(x, x) * inner(v, v)) return premise_fails();
  const double exact = along_light(drawn, [](const V& u) { return u[2]; });
  const double received = subject.reflection(drawn.light, {}, drawn.view, drawn.model, 1).received.value;
  if (!is_close(received, exact)) return verdict(false, "the irradiance differs from the definition");
  std::ostringstream text;
  text.precision(10);
  text << "printed " << printed_diffuse(drawn) << ", true " << exact;
  return is_close(printed_diffuse(drawn), exact) ? Verdict{} : refutes(text.str());
}

/// [P93] (3.8) and (3.11): that N . H may be put for R . L.
Verdict check_same_lobe(const ReflectionCase& drawn, const Subject& subject) {
  const V e = difference(drawn.view.to_eye, {0, 0, 0});
  const double length = size(e);
  const V eye{e[0] / length, e[1] / length, e[2] / length}, mirror{-eye[0], -eye[1], eye[2]};
  const int n = drawn.exponent;
  const double by_mirror = along_light(drawn, [&](const V& u) { return std::pow(std::fmax(inner(mirror, u), 0), n); });
  const double by_half = along_light(drawn, [&](const V& u) {
    const V h{u[0] + eye[0], u[1] + eye[1], u[2] + eye[2]};
    return std::pow(std::fmax(h[2] / size(h), 0), n);
  });
  const Reflection r = subject.reflection(drawn.light, {}, drawn.view, ReflectionModel::phong_classic, n);
  const Reflection b = subject.reflection(drawn.light, {}, drawn.view, ReflectionModel::blinn_classic, n);
  const double slack = 1e-3 * along_light(drawn, [](const V&) { return 1; });
  if (std::fabs(r.lobe.value - by_mirror) > slack || std::fabs(b.lobe.value - by_half) > slack) {
    return verdict(false, "a lobe differs from the definition");
  }
  std::ostringstream text;
  text << "the integral of (R . L)^n is " << by_mirror << ", that of (N . H)^n " << by_half;
  return std::fabs(by_mirror - by_half) <= slack ? Verdict{} : refutes(text.str());
}

/// A number of the papers' formulas: an exponent and a share of 1.
struct CurveCase {
  int exponent = 1;
  double share = 0.5;
};

std::string description(const CurveCase& drawn) {
  std::ostringstream out;
  out.precision(17);
  out << "exponent " << drawn.exponent << ", share " << drawn.share << '\n';
  return out.str();
}

rc::Gen<CurveCase> curves(Domain domain) {
  return rc::gen::exec([domain] {
    const int most = domain == Domain::random ? 64 : 10000;
    return CurveCase{draw(1, most), draw(1, 31) / 32.0};
  });
}

/// Interpolates cos^n on [0, end] in 7 Chebyshev extrema, and tells how far off the polynomial is at most.
double interpolation_error(int n, double end) {
  constexpr int degree = 6;
  const auto lobe = [n](double x) { return std::pow(std::fmax(std::cos(x), 0), n); };
  std::array<double, degree + 1> value{};
  const auto node = [&](int k) { return end * (1 + std::cos(pi * k / degree)) / 2; };
  for (int k = 0; k <= degree; ++k) value[std::size_t(k)] = lobe(node(k));
  double worst = 0;
  for (int i = 0; i <= 400; ++i) {
    const double x = end * i / 400;
    double above = 0, below = 0;
    bool is_node = false;
    for (int k = 0; k <= degree; ++k) {
      const double weight = (k % 2 == 0 ? 1 : -1) * (k == 0 || k == degree ? 0.5 : 1), step = x - node(k);
      is_node |= step == 0;
      above += weight * value[std::size_t(k)] / step;
      below += weight / step;
    }
    if (!is_node) worst = std::fmax(worst, std::fabs(above / below - lobe(x)));
  }
  return worst;
}

constexpr double epsilon = 1 / 250.0;

Verdict check_degree_six(const CurveCase& drawn, const Subject&) {
  const double printed = std::pow(std::acos(epsilon), 1.0 / drawn.exponent);
  const double error = interpolation_error(drawn.exponent, printed);
  const double right = interpolation_error(drawn.exponent, std::acos(std::pow(epsilon, 1.0 / drawn.exponent)));
  if (right > epsilon) return verdict(false, "not even with the right end");
  std::ostringstream text;
  text << "off by " << error << "; to acos(eps^(1/n)) by " << right;
  return error <= epsilon ? Verdict{} : refutes(text.str());
}

/// [P93] Figure 3.9: Chebyshev's sum with x_cheby left at -1 has a_i = (-1)^i b_i.
Verdict check_second_loop(const CurveCase& drawn, const Subject&) {
  const double end = std::acos(std::pow(epsilon, 1.0 / drawn.exponent));
  constexpr int degree = 6;
  const auto lobe = [&](double t) { return std::pow(std::cos(end * (1 + t) / 2), drawn.exponent); };
  double printed = 0, right = 0;
  const double t = 2 * drawn.share - 1;
  for (int i = 0; i <= degree; ++i) {
    double b = 0;
    for (int k = 0; k <= degree; ++k) {
      const double half = k == 0 || k == degree ? 0.5 : 1;
      b += half * lobe(std::cos(pi * k / degree)) * std::cos(pi * i * k / degree);
    }
    b *= (i == 0 || i == degree ? 1.0 : 2.0) / degree;
    const double term = b * std::cos(i * std::acos(t));
    right += term;
    printed += i % 2 == 0 ? term : -term;
  }
  if (std::fabs(right - lobe(t)) > epsilon) return verdict(false, "the right sum is off");
  std::ostringstream text;
  text << "printed " << printed << " for " << lobe(t);
  return std::fabs(printed - lobe(t)) <= epsilon ? Verdict{} : refutes(text.str());
}

/// Its lobe over the cosine at incidence: what comes back of what arrives is (n+1)/2pi times the integral of (R . L)^n.
Verdict check_classic_is_reciprocal(const CurveCase& drawn, const Subject& subject) {
  const double angle = drawn.share * pi / 2;
  const Point3 low{std::sin(angle), 0, std::cos(angle)}, high{0, 0.3, 1};
  const auto brdf = [&](const Point3& light, const Point3& eye) {
    const DirectionalLight sun{{-light.x, -light.y, -light.z}};
    const gnomon::View view{{0, 0, 0}, {0, 0, 1}, eye};
    const Reflection r = subject.reflection(sun, {}, view, ReflectionModel::phong_classic, drawn.exponent);
    return r.lobe.value / r.received.value;
  };
  const double there = brdf(low, high), back = brdf(high, low);
  std::ostringstream text;
  text << "from light to eye " << there << " per sr, back " << back;
  return is_close(there, back) ? Verdict{} : refutes(text.str());
}

/// [P93] 3.2.2: with k cos(beta) the light of flux Phi per length has k = Phi / 4 pi.
Verdict check_cosine_flux(const CurveCase& drawn, const Subject&) {
  const int m = 1 + drawn.exponent % 10;
  double emitted = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    emitted += std::pow(std::cos(pi * ((i + 0.5) / steps - 0.5)), m + 1) * pi / steps;
  }
  const double share = 2 * pi * emitted / (4 * pi);
  std::ostringstream text;
  text << "with cos^" << m << " it emits " << share << " of that flux";
  return std::fabs(share - 1) < 1e-6 ? Verdict{} : refutes(text.str());
}

/// [P93] 3.1.4: two lights of one solid angle give the same irradiance.
Verdict check_solid_angle(const CurveCase& drawn, const Subject& subject) {
  const double angle = drawn.share * 80 * pi / 180, s = std::sin(angle), c = std::cos(angle);
  const auto patch = [&](double sine, double cosine) {
    const double half = 0.01;
    const auto corner = [&](double x, double y) {
      return Point3{sine + half * x * cosine, half * y, cosine - half * x * sine};
    };
    return AreaLight{ConvexPolygon::from_points({corner(1, 1), corner(1, -1), corner(-1, 1)}), true};
  };
  const gnomon::View view{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  const double above = subject.reflection(patch(0, 1), {}, view, ReflectionModel::phong, 0).received.value;
  const double aside = subject.reflection(patch(s, c), {}, view, ReflectionModel::phong, 0).received.value;
  if (std::fabs(aside - c * above) > 0.03 * above) return verdict(false, "not the projected solid angle either");
  std::ostringstream text;
  text << "irradiances " << above << " and " << aside << " of one solid angle";
  return is_close(above, aside) ? Verdict{} : refutes(text.str());
}

/// [Ph73] IV.1: vertex normals do not depend on how facets are cut. A box's corner, one face cut by its diagonal.
Verdict check_any_vertex_normal(const CurveCase& drawn, const Subject&) {
  const double twist = drawn.share;  // of the second face, so that corners differ
  const V up{0, 0, 1}, right{1, 0, 0}, back{-twist / 2, std::sqrt(1 - twist * twist / 4), 0};
  const auto sum = [&](double of_up) {
    return V{of_up * up[0] + right[0] + back[0], of_up * up[1] + right[1] + back[1],
             of_up * up[2] + right[2] + back[2]};
  };
  const V whole = sum(1), cut = sum(2);
  const double cosine = inner(whole, cut) / (size(whole) * size(cut));
  const double angle = std::acos(std::fmin(cosine, 1)) * 180 / pi;
  std::ostringstream text;
  text << "the diagonal turns the normal by " << angle << " degrees";
  return angle < 1e-3 ? Verdict{} : refutes(text.str());
}

/// [Ph73] IV.2: interpolating along edges and scan lines does not depend on how the picture is turned. A square with
/// normals z, t, z, t at its corners, t tilted; the middle as rows along sides have it, and as rows along a diagonal.
Verdict check_scan_lines(const CurveCase& drawn, const Subject&) {
  const double tilt = drawn.share * pi / 2;
  const V z{0, 0, 1}, t{std::sin(tilt), 0, std::cos(tilt)};
  const V along_sides{t[0] / 2 + z[0] / 2, 0, t[2] / 2 + z[2] / 2};                     // means of means
  const double by_sides = std::atan2(along_sides[0], along_sides[2]), by_diagonal = 0;  // between two corners z
  std::ostringstream text;
  text << "the middle tilts by " << by_sides * 180 / pi << " degrees, or by " << by_diagonal;
  return std::fabs(by_sides - by_diagonal) < 1e-6 ? Verdict{} : refutes(text.str());
}

}  // namespace

std::vector<Law> reflection_claims() {
  const ReflectionCase tube = tube_case({0, 0, 1}, {2, 0, 1}, {0, 0, 1}, 1);
  const ReflectionCase long_tube = tube_case({-5, 0, 1}, {5, 0, 1}, {0, 0, 1}, 64);
  return {
      refuted_claim<ReflectionCase>({"G1", "[PA90] 3", "The antiderivative, as printed, is the diffuse term."}, {tube},
                                    tubes, check_printed_diffuse),
      refuted_claim<CurveCase>(
          {"G2", "[P93] 3.2.1.2",
           "Up to x_M = (acos eps)^(1/n), eps = 1/250, a polynomial of degree 6 is within eps of cos^n."},
          {{32, 0.5}, {64, 0.5}, {200, 0.5}}, curves, check_degree_six),
      refuted_claim<CurveCase>({"G3", "[P93] Fig. 3.9", "The second loop, as printed, sums the polynomial."},
                               {{10, 0.0625}, {64, 0.9375}}, curves, check_second_loop),
      refuted_claim<ReflectionCase>({"G4", "[P93] 3.2.1", "R . L may be substituted for N . H."}, {long_tube}, tubes,
                                    check_same_lobe),
      refuted_claim<CurveCase>(
          {"G5", "[PA90] 4, [Ph73] 4.5", "Light and eye may change places in the lobe (R . L)^n without a cosine."},
          {{10, 0.75}}, curves, check_classic_is_reciprocal),
      refuted_claim<CurveCase>({"G6", "[P93] 3.2.2", "With cosine emission too, k is the flux per length over 4 pi."},
                               {{10, 0.5}}, curves, check_cosine_flux),
      refuted_claim<CurveCase>(
          {"G7", "[P93] 3.1.4", "The radiance received of a small light goes with its solid angle."}, {{1, 1}}, curves,
          check_solid_angle),
      refuted_claim<CurveCase>({"G8", "[Ph73] IV.1", "Any scheme of averaging normals at vertices is adequate."},
                               {{1, 0}}, curves, check_any_vertex_normal),
      refuted_claim<CurveCase>(
          {"G9", "[Ph73] IV.2", "Normals interpolated along scan lines do not depend on how the picture is turned."},
          {{1, 0.5}}, curves, check_scan_lines),
  };
}

}  // namespace gnomon::laws
