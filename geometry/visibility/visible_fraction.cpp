#include "geometry/visibility/visible_fraction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

/// A double that is no smaller than the number.
double rounded_up(const Rational& number) {
  const double nearest = nearest_double(number);
  return Rational(nearest) < number ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
}

Rational distance(const Rational& a, const Rational& b) {
  return a < b ? Rational(b - a) : Rational(a - b);
}

VisibleFraction rounded(const Rational& exact) {
  const double nearest = nearest_double(exact);
  return {nearest, rounded_up(distance(exact, Rational(nearest))), exact};
}

VisibleFraction rounded(const Rational& least, const Rational& most) {
  if (least == most) return rounded(least);
  const double nearest = nearest_double(least);
  const Rational below = distance(least, Rational(nearest));
  const Rational above = distance(most, Rational(nearest));
  return {nearest, rounded_up(std::max(below, above)), std::nullopt};
}

/// Numbers that enclose one; they are equal where it is known exactly.
struct Enclosure {
  Rational least = 0;
  Rational most = 0;
};

/// The power of two just below a positive number, or the one below that.
long exponent_of(const Rational& number) {
  return static_cast<long>(msb(numerator(number))) - static_cast<long>(msb(denominator(number))) - 1;
}

/// The number rounded down to a multiple of 2^-bits, in these multiples.
Integer in_units(const Rational& number, long bits) {
  if (bits >= 0) return (numerator(number) << static_cast<unsigned long>(bits)) / denominator(number);
  return numerator(number) / (denominator(number) << static_cast<unsigned long>(-bits));
}

Rational from_units(const Integer& units, long bits) {
  const Integer one = 1;
  if (bits >= 0) return {units, Integer(one << static_cast<unsigned long>(bits))};
  return {Integer(units << static_cast<unsigned long>(-bits)), one};
}

/// The sum of positive numbers: exact if they are few. The common denominator of many is too long to work with; their
/// sum is enclosed to a relative 2^-300 of the largest.
Enclosure sum_of(const std::vector<Rational>& terms) {
  if (terms.size() <= 64) {
    const Rational sum = std::accumulate(terms.begin(), terms.end(), Rational(0));
    return {sum, sum};
  }
  const long bits = 300 - exponent_of(*std::max_element(terms.begin(), terms.end()));
  Integer sum = 0;
  for (const Rational& term : terms) sum += in_units(term, bits);
  return {from_units(sum, bits), from_units(sum + terms.size(), bits)};
}

/// The square root of a positive number, to a relative 2^-190.
Enclosure square_root(const Rational& number) {
  const Integer bottom = denominator(number);
  Integer square = numerator(number) * bottom;
  const std::size_t bits = msb(square);
  const unsigned shift = bits < 400 ? static_cast<unsigned>(400 - bits + 1) / 2 : 0;
  square <<= 2 * shift;
  const Integer scale = bottom << shift;
  const Integer root = sqrt(square);
  return {Rational(root, scale), Rational(root + 1, scale)};
}

/// The share that polygons have of a facet's area; all lie in its plane, so one component of their normals tells.
Enclosure share_of(const ExactPolygon& facet, std::span<const ExactPolygon> polygons) {
  const ExactVector whole = doubled_area(facet);
  const auto component = [&](const ExactVector& v) { return whole.z != 0 ? v.z : whole.y != 0 ? v.y : v.x; };
  std::vector<Rational> shares;
  for (const ExactPolygon& polygon : polygons) shares.push_back(component(doubled_area(polygon)) / component(whole));
  return sum_of(shares);
}

/// The mean of a share of every facet, weighed by area.
template <class Share>
VisibleFraction mean_share(const std::vector<VisibleFacet>& facets, Share share) {
  std::vector<Enclosure> shares;
  for (const VisibleFacet& facet : facets) shares.push_back(share(facet));
  if (facets.size() == 1) return rounded(shares[0].least, shares[0].most);
  Enclosure visible, whole;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const ExactVector normal = doubled_area(facets[i].facet);
    const Enclosure area = square_root(dot(normal, normal));
    visible.least += shares[i].least * area.least;
    visible.most += shares[i].most * area.most;
    whole.least += area.least;
    whole.most += area.most;
  }
  return rounded(visible.least / whole.most, visible.most / whole.least);
}

}  // namespace

VisibleFraction visible_fraction(const VisiblePart& part) {
  if (part.region == Region::lit) return fraction_before(part);
  if (part.region != Region::penumbra) return rounded(0);
  if (!part.facets.empty()) {
    return mean_share(part.facets, [](const VisibleFacet& seen) { return share_of(seen.facet, seen.visible); });
  }
  Rational length = 0;
  for (const VisiblePart::Interval& interval : part.intervals) length += interval[1] - interval[0];
  return rounded(length);
}

VisibleFraction fraction_before(const VisiblePart& part) {
  if (!part.any_before) return rounded(0);
  const auto is_whole = [](const VisibleFacet& seen) { return seen.before == seen.facet; };
  if (part.facets.empty()) return rounded(Rational((*part.before)[1] - (*part.before)[0]));
  if (std::all_of(part.facets.begin(), part.facets.end(), is_whole)) return rounded(1);
  return mean_share(part.facets, [](const VisibleFacet& seen) {
    if (seen.before.empty()) return Enclosure{};
    return share_of(seen.facet, {&seen.before, 1});
  });
}

}  // namespace gnomon
