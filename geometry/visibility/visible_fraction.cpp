#include "geometry/visibility/visible_fraction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/rounding.h"

namespace gnomon {
namespace {

/// A double that is no smaller than the number.
double rounded_up(const Rational& number) {
  const double nearest = nearest_double(number);
  return Rational(nearest) < number ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
}

VisibleFraction rounded(const Rational& exact) {
  const double nearest = nearest_double(exact);
  return {nearest, rounded_up(abs(Rational(exact - Rational(nearest)))), exact};
}

VisibleFraction rounded(const Rational& least, const Rational& most) {
  const double nearest = nearest_double(least);
  const Rational below = abs(Rational(least - Rational(nearest)));
  const Rational above = abs(Rational(most - Rational(nearest)));
  return {nearest, rounded_up(std::max(below, above)), std::nullopt};
}

/// Two numbers, at a relative 2^-190 of each other or nearer, with the square root of a positive number between them.
std::pair<Rational, Rational> square_root(const Rational& number) {
  using Integer = boost::multiprecision::mpz_int;
  const Integer bottom = denominator(number);
  Integer square = numerator(number) * bottom;
  const std::size_t bits = msb(square);
  const unsigned shift = bits < 400 ? static_cast<unsigned>(400 - bits + 1) / 2 : 0;
  square <<= 2 * shift;
  const Integer scale = bottom << shift;
  const Integer root = sqrt(square);
  return {Rational(root, scale), Rational(root + 1, scale)};
}

/// The share of a facet's area; all polygons lie in its plane, so one component of their normals tells.
Rational visible_share(const SeenFacet& seen) {
  const ExactVector whole = doubled_area(seen.facet);
  const auto component = [&](const ExactVector& v) { return whole.z != 0 ? v.z : whole.y != 0 ? v.y : v.x; };
  Rational sum = 0;
  for (const ExactPolygon& polygon : seen.visible) sum += component(doubled_area(polygon));
  return sum / component(whole);
}

VisibleFraction mean_share(const std::vector<SeenFacet>& facets) {
  std::vector<Rational> shares;
  for (const SeenFacet& facet : facets) shares.push_back(visible_share(facet));
  const auto equals_first = [&](const Rational& share) { return share == shares.front(); };
  if (std::all_of(shares.begin(), shares.end(), equals_first)) return rounded(shares.front());
  Rational least_visible = 0, most_visible = 0, least_whole = 0, most_whole = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const ExactVector normal = doubled_area(facets[i].facet);
    const auto [least, most] = square_root(dot(normal, normal));
    least_visible += shares[i] * least;
    most_visible += shares[i] * most;
    least_whole += least;
    most_whole += most;
  }
  return rounded(least_visible / most_whole, most_visible / least_whole);
}

}  // namespace

VisibleFraction visible_fraction(const VisiblePart& part) {
  if (part.region == Region::lit) return rounded(1);
  if (part.region != Region::penumbra) return rounded(0);
  if (!part.facets.empty()) return mean_share(part.facets);
  Rational length = 0;
  for (const VisiblePart::Interval& interval : part.intervals) length += interval[1] - interval[0];
  return rounded(length);
}

}  // namespace gnomon
