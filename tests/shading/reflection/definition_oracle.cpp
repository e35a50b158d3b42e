#include "tests/shading/reflection/definition_oracle.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>

namespace gnomon::test_support {
namespace {

template <class Real>
struct Space {
  Real x, y, z;
};

template <class Real>
Space<Real> operator+(const Space<Real>& a, const Space<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Space<Real> operator-(const Space<Real>& a, const Space<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
Space<Real> operator*(const Real& s, const Space<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
Real inner(const Space<Real>& a, const Space<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Space<Real> outer(const Space<Real>& a, const Space<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
Space<Real> space(const Point3& p) {
  return {Real(p.x), Real(p.y), Real(p.z)};
}

template <class Real>
Space<Real> normalised(const Space<Real>& a) {
  using std::sqrt;
  return Real(1) / sqrt(inner(a, a)) * a;
}

/// Nodes and weights of Gauss's rule by Newton's method.
template <class Real, int count>
struct Rule {
  std::array<Real, count> node, weight;

  Rule() {
    for (int i = 0; i < count; ++i) {
      Real z = Real(std::cos(3.14159265358979323846 * (i + 0.75) / (count + 0.5))), slope = 0;
      for (int round = 0; round < 8; ++round) {
        Real before = 1, p = z;
        for (int k = 2; k <= count; ++k) {
          const Real next = (Real(2 * k - 1) * z * p - Real(k - 1) * before) / Real(k);
          before = p;
          p = next;
        }
        slope = Real(count) * (z * p - before) / (z * z - Real(1));
        z -= p / slope;
      }
      node[static_cast<std::size_t>(i)] = z;
      weight[static_cast<std::size_t>(i)] = Real(2) / ((Real(1) - z * z) * slope * slope);
    }
  }
};

template <class Real>
Integrated<Real> operator+(const Integrated<Real>& a, const Integrated<Real>& b) {
  return {a.received + b.received, a.lobe + b.lobe, a.across + b.across, a.is_certain && b.is_certain};
}

template <class Real>
Integrated<Real> operator*(const Real& s, const Integrated<Real>& a) {
  return {s * a.received, s * a.lobe, s * a.across, a.is_certain};
}

template <class Real>
Real larger(const Real& a, const Real& b) {
  return a < b ? b : a;
}

/// The integrand per dE_p for light from X.
template <class Real>
class Surface {
 public:
  Surface(const View& view, ReflectionModel model, int exponent)
      : normal(normalised(space<Real>(view.normal))),
        eye(normalised(space<Real>(view.to_eye))),
        mirror(Real(2) * inner(normal, eye) * normal - eye),
        model_(model),
        exponent_(exponent) {}

  Integrated<Real> from(const Space<Real>& x) const {
    using std::pow;
    const Space<Real> light = normalised(x);
    const Real cosine = larger(Real(0), inner(normal, light));
    if (cosine == 0) return {0, 0, 1};
    const bool halfway = model_ == ReflectionModel::blinn || model_ == ReflectionModel::blinn_classic;
    const Real base = halfway ? inner(normal, normalised(light + eye)) : larger(Real(0), inner(mirror, light));
    Real lobe = exponent_ == 0 ? Real(base > 0 ? 1 : 0) : Real(pow(base, exponent_));
    if (model_ == ReflectionModel::phong || model_ == ReflectionModel::blinn) lobe *= cosine;
    return {cosine, lobe, 1};
  }

  Space<Real> normal, eye, mirror;

 private:
  ReflectionModel model_;
  int exponent_;
};

template <class Real>
bool agree(const Integrated<Real>& a, const Integrated<Real>& b, const Real& share) {
  using std::abs;
  return abs(a.received - b.received) <= share && abs(a.lobe - b.lobe) <= share;
}

class LineIntegral {
 public:
  LineIntegral(const LinearLight& light, const View& view, ReflectionModel model, int exponent)
      : surface_(view, model, exponent),
        from_(space<Long>(light.start) - space<Long>(view.point)),
        along_(space<Long>(light.end) - space<Long>(light.start)),
        length_(sqrt(inner(along_, along_))),
        emission_(light.emission) {}

  Integrated<Long> total() {
    std::vector<Long> cuts = {0, 1};
    for (const Space<Long>& w : {surface_.normal, surface_.mirror}) {
      const Long slope = inner(w, along_), start = inner(w, from_);
      if (slope != 0 && -start / slope > 0 && -start / slope < 1) cuts.push_back(-start / slope);
    }
    // Where the light is nearest: there halves are needed first.
    const Long near = -inner(from_, along_) / inner(along_, along_);
    if (near > 0 && near < 1) cuts.push_back(near);
    for (const Long& cut : flap_cuts(near)) {
      if (cut > 0 && cut < 1) cuts.push_back(cut);
    }
    std::sort(cuts.begin(), cuts.end());
    Integrated<Long> sum;
    std::vector<Integrated<Long>> whole;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      is_shining_ = is_in_wedge() && is_between_flaps((cuts[k] + cuts[k + 1]) / 2);
      whole.push_back(rule(cuts[k], cuts[k + 1]));
    }
    for (const auto& part : whole) sum = sum + part;
    share_ = Long(1e-25) * sum.across;
    sum = {};
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      is_shining_ = is_in_wedge() && is_between_flaps((cuts[k] + cuts[k + 1]) / 2);
      sum = sum + halved(cuts[k], cuts[k + 1], whole[k], 90);
    }
    return sum;
  }

 private:
  Integrated<Long> rule(const Long& a, const Long& b) const {
    static const Rule<Long, 20> gauss;
    Integrated<Long> sum;
    for (std::size_t i = 0; i < gauss.node.size(); ++i) {
      const Space<Long> x = from_ + (a + (b - a) * (1 + gauss.node[i]) / 2) * along_;
      Integrated<Long> part = surface_.from(x);
      const Long emitted = is_shining_ ? Long(pow(sine_to_axis(x), emission_.exponent)) : Long(0);
      part.received *= emitted;
      part.lobe *= emitted;
      sum = sum + Long(gauss.weight[i] / inner(x, x)) * part;
    }
    return Long((b - a) / 2 * length_) * sum;
  }
  /// Of the angle between a direction and the light's axis: the cosine of the one from the planes across it.
  Long sine_to_axis(const Space<Long>& x) const {
    const Space<Long> across = outer(along_, x);
    return sqrt(Long(inner(across, across) / (inner(along_, along_) * inner(x, x))));
  }
  static Long degree() { return boost::math::constants::pi<Long>() / 180; }
  bool is_between_flaps(const Long& share) const {
    return !emission_.flaps || sine_to_axis(from_ + share * along_) >= cos(Long(*emission_.flaps * degree()));
  }
  /// Where the angle to the planes across the light is that of the flaps.
  std::vector<Long> flap_cuts(const Long& near) const {
    if (!emission_.flaps) return {};
    const Space<Long> foot = from_ + near * along_;
    const Long away = sqrt(inner(foot, foot)) * tan(Long(*emission_.flaps * degree())) / length_;
    return {near - away, near + away};
  }
  /// By angles about the axis, in the way of a clock that is looked at from behind.
  bool is_in_wedge() const {
    if (!emission_.shade) return true;
    const Space<Long> zero = space<Long>(emission_.shade->from);
    const auto angle = [&](const Space<Long>& x) {
      const Long turned = atan2(Long(inner(along_, outer(zero, x)) * length_),
                                Long(inner(zero, x) * inner(along_, along_) - inner(zero, along_) * inner(x, along_)));
      return Long(turned < 0 ? turned + 360 * degree() : turned);
    };
    return angle(Long(-1) * from_) <= angle(space<Long>(emission_.shade->to));
  }
  Integrated<Long> halved(const Long& a, const Long& b, const Integrated<Long>& whole, int depth) {
    const Long middle = (a + b) / 2;
    const Integrated<Long> left = rule(a, middle), right = rule(middle, b), sum = left + right;
    const Long share = larger(share_, Long(1e-25 * sum.across)), across = abs(sum.across - whole.across);
    if (agree(sum, whole, share) && across <= 1e6 * share) return sum;
    if (depth == 0 || --halvings_left_ < 0) return {sum.received, sum.lobe, sum.across, false};
    return halved(a, middle, left, depth - 1) + halved(middle, b, right, depth - 1);
  }

  Surface<Long> surface_;
  Space<Long> from_, along_;
  Long length_;
  Emission emission_;
  bool is_shining_ = true;     ///< where the rule is used
  int halvings_left_ = 20000;  ///< where rounding decides about a lobe there is no end
  Long share_;
};

using Wide = long double;
using Corners = std::vector<Space<Wide>>;

Corners before(const Corners& polygon, const Space<Wide>& w) {
  Corners result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Space<Wide>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const Wide from = inner(w, a), to = inner(w, b);
    if (from >= 0) result.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) result.push_back(a + from / (from - to) * (b - a));
  }
  return result;
}

class PolygonIntegral {
 public:
  PolygonIntegral(const View& view, ReflectionModel model, int exponent) : surface_(view, model, exponent) {}

  /// Two regions with integrands that are smooth: where R . X is negative only the cosine counts for a lobe about R.
  Integrated<Wide> total(const Corners& corners) {
    const Corners above = before(corners, surface_.normal);
    Integrated<Wide> sum;
    for (const Wide side : {Wide(1), Wide(-1)}) {
      const Corners part = before(above, side * surface_.mirror);
      for (std::size_t k = 1; k + 1 < part.size(); ++k) {
        const Triangle triangle{part[0], part[k] - part[0], part[k + 1] - part[0]};
        const Integrated<Wide> whole = rule(triangle);
        share_ = 1e-17L * whole.across;
        sum = sum + quartered(triangle, whole, 7);
      }
    }
    return sum;
  }

 private:
  /// A corner and the ways to the others, which halving keeps exact.
  struct Triangle {
    Space<Wide> a, ab, ac;
  };

  Integrated<Wide> rule(const Triangle& t) const {
    static const Rule<Wide, 12> gauss;
    const Space<Wide> bc = t.ac - t.ab, doubled = outer(t.ab, t.ac);
    Integrated<Wide> sum;
    for (std::size_t i = 0; i < gauss.node.size(); ++i) {
      const Wide p = (1 + gauss.node[i]) / 2;
      for (std::size_t j = 0; j < gauss.node.size(); ++j) {
        const Space<Wide> x = t.a + p * t.ab + Wide(p * (1 + gauss.node[j]) / 2) * bc;
        const Wide r = std::sqrt(inner(x, x));
        const Wide solid = std::fabs(inner(doubled, t.a)) / (r * r * r);
        sum = sum + Wide(gauss.weight[i] * gauss.weight[j] / 4 * p * solid) * surface_.from(x);
      }
    }
    return sum;
  }
  Integrated<Wide> quartered(const Triangle& t, const Integrated<Wide>& whole, int depth) const {
    const Wide half = 0.5L;
    const Space<Wide> ab = half * t.ab, ac = half * t.ac, back_ab = -half * t.ab, back_ac = -half * t.ac;
    const std::array<Triangle, 4> quarters = {
        {{t.a, ab, ac}, {t.a + ab, ab, ac}, {t.a + ac, ab, ac}, {t.a + ab + ac, back_ab, back_ac}}};
    std::array<Integrated<Wide>, 4> parts;
    std::transform(quarters.begin(), quarters.end(), parts.begin(), [this](const Triangle& q) { return rule(q); });
    Integrated<Wide> sum = (parts[0] + parts[1]) + (parts[2] + parts[3]);
    if (agree(sum, whole, share_)) return sum;
    if (depth == 0) return {sum.received, sum.lobe, sum.across, false};
    sum = {};
    for (std::size_t k = 0; k < parts.size(); ++k) sum = sum + quartered(quarters[k], parts[k], depth - 1);
    return sum;
  }

  Surface<Wide> surface_;
  Wide share_ = 0;
};

}  // namespace

Integrated<Long> integrated_line(const LinearLight& light, const View& view, ReflectionModel model, int exponent) {
  return LineIntegral(light, view, model, exponent).total();
}

Integrated<long double> integrated_polygon(const std::vector<Point3>& corners, const View& view, ReflectionModel model,
                                           int exponent) {
  Corners relative;
  for (const Point3& corner : corners) relative.push_back(space<Wide>(corner) - space<Wide>(view.point));
  return PolygonIntegral(view, model, exponent).total(relative);
}

Integrated<Long> integrand_towards(const Point3& towards, const View& view, ReflectionModel model, int exponent) {
  return Surface<Long>(view, model, exponent).from(space<Long>(towards));
}

}  // namespace gnomon::test_support
