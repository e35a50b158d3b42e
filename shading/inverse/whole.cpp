#include "shading/inverse/whole.h"

#include <algorithm>

#include "geometry/spatial/homogeneous.h"

namespace gnomon::inverse {
namespace {

/// An extreme ray of a cone, and the generators at right angles to it.
struct PolarRay {
  Whole ray;
  std::vector<std::uint32_t> touched;
};

bool is_nothing(const Whole& v) {
  return std::ranges::all_of(v, [](const Integer& x) { return x == 0; });
}

Whole opposite(const Whole& v) {
  return {Integer(-v[0]), Integer(-v[1]), Integer(-v[2]), Integer(-v[3])};
}

/// Four generators that are independent; fewer if there are no four.
std::vector<std::uint32_t> independent(std::span<const Whole> generators) {
  std::vector<std::uint32_t> chosen;
  std::vector<std::array<Rational, 4>> rows;
  for (std::uint32_t g = 0; g < generators.size() && chosen.size() < 4; ++g) {
    std::array<Rational, 4> row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = Rational(generators[g][k]);
    for (const auto& earlier : rows) {
      const std::size_t pivot = static_cast<std::size_t>(
          std::ranges::find_if(earlier, [](const Rational& x) { return x != 0; }) - earlier.begin());
      const Rational factor = row[pivot] / earlier[pivot];
      for (std::size_t k = 0; k < 4; ++k) row[k] -= factor * earlier[k];
    }
    if (std::ranges::all_of(row, [](const Rational& x) { return x == 0; })) continue;
    rows.push_back(row);
    chosen.push_back(g);
  }
  return chosen;
}

std::vector<std::uint32_t> common(const PolarRay& a, const PolarRay& b) {
  std::vector<std::uint32_t> result;
  std::ranges::set_intersection(a.touched, b.touched, std::back_inserter(result));
  return result;
}

/// Two rays span a face of the cone if no third one touches all that both touch.
bool are_neighbours(const std::vector<PolarRay>& rays, std::size_t i, std::size_t j,
                    const std::vector<std::uint32_t>& both) {
  if (both.size() < 2) return false;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (k != i && k != j && std::ranges::includes(rays[k].touched, both)) return false;
  }
  return true;
}

Whole between(const Whole& u, const Integer& hu, const Whole& v, const Integer& hv) {
  Whole result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = u[k] * hv - v[k] * hu;
  return reduced(std::move(result));
}

/// The rays of the cone within one more half-space.
std::vector<PolarRay> cut(const std::vector<PolarRay>& rays, const Whole& generator, std::uint32_t number) {
  std::vector<Integer> height;
  for (const PolarRay& ray : rays) height.push_back(value(generator, ray.ray));
  std::vector<PolarRay> result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (height[i] > 0) continue;
    result.push_back(rays[i]);
    if (height[i] == 0) {
      auto& touched = result.back().touched;
      touched.insert(std::ranges::lower_bound(touched, number), number);
      continue;
    }
    for (std::size_t j = 0; j < rays.size(); ++j) {
      if (height[j] <= 0) continue;
      std::vector<std::uint32_t> both = common(rays[i], rays[j]);
      if (!are_neighbours(rays, i, j, both)) continue;
      both.insert(std::ranges::lower_bound(both, number), number);
      result.push_back({between(rays[i].ray, height[i], rays[j].ray, height[j]), std::move(both)});
    }
  }
  return result;
}

/// The rays of the cone of all half-spaces that hold four independent generators.
std::vector<PolarRay> first_rays(std::span<const Whole> generators, const std::vector<std::uint32_t>& four) {
  std::vector<PolarRay> rays;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    std::vector<std::uint32_t> touched;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k != left_out) touched.push_back(four[k]);
    }
    Whole ray = complement(generators[touched[0]], generators[touched[1]], generators[touched[2]]);
    if (value(ray, generators[four[left_out]]) > 0) ray = opposite(ray);
    rays.push_back({std::move(ray), std::move(touched)});
  }
  return rays;
}

}  // namespace

Whole reduced(Whole numbers) {
  Integer divisor = 0;
  for (const Integer& x : numbers) divisor = gcd(divisor, x);
  if (divisor <= 1) return numbers;
  for (Integer& x : numbers) x /= divisor;
  return numbers;
}

Whole whole_point(const ExactVector& p) {
  return reduced(whole_coordinates(p));
}

Whole whole_point(const Point3& p) {
  return whole_point(exact(p));
}

Whole whole_direction(const ExactVector& v) {
  Whole whole = whole_coordinates(v);
  whole[3] = 0;
  return reduced(std::move(whole));
}

Whole whole_direction(const Point3& v) {
  return whole_direction(exact(v));
}

Whole whole_plane(const ExactVector& normal, const Rational& offset) {
  Whole whole = whole_coordinates(normal);
  const Integer w = denominator(offset);
  const Rational last = offset * Rational(whole[3]);
  for (std::size_t k = 0; k < 3; ++k) whole[k] *= w;
  whole[3] = numerator(Rational(last * Rational(w)));
  return reduced(std::move(whole));
}

Whole whole_plane(const HalfSpace& half_space) {
  // Sums and products of doubles, whose denominators are powers of two.
  const auto numbers = point_coefficients<ExactReal>(half_space.plane, half_space.third_is_direction);
  std::array<Rational, 4> exact_numbers;
  Integer largest = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    exact_numbers[k] = rational(numbers[k]);
    largest = std::max(largest, Integer(denominator(exact_numbers[k])));
  }
  Whole whole;
  for (std::size_t k = 0; k < 4; ++k) {
    whole[k] = numerator(exact_numbers[k]) * Integer(largest / denominator(exact_numbers[k]));
  }
  return reduced(std::move(whole));
}

Integer value(const Whole& plane, const Whole& point) {
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

ExactVector normal_of(const Whole& plane) {
  return {Rational(plane[0]), Rational(plane[1]), Rational(plane[2])};
}

ExactVector coordinates(const Whole& point) {
  return {Rational(point[0], point[3]), Rational(point[1], point[3]), Rational(point[2], point[3])};
}

Whole complement(const Whole& a, const Whole& b, const Whole& c) {
  return reduced(unreduced_complement(a, b, c));
}

Whole unreduced_complement(const Whole& a, const Whole& b, const Whole& c) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) -> Integer {
    return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) + a[k] * (b[i] * c[j] - b[j] * c[i]);
  };
  return {minor(1, 2, 3), Integer(-minor(0, 2, 3)), minor(0, 1, 3), Integer(-minor(0, 1, 2))};
}

std::optional<std::vector<Whole>> hull_half_spaces(std::span<const Whole> generators) {
  const std::vector<std::uint32_t> four = independent(generators);
  if (four.size() < 4) return std::nullopt;
  std::vector<PolarRay> rays = first_rays(generators, four);
  for (std::uint32_t g = 0; g < generators.size(); ++g) {
    if (std::ranges::find(four, g) == four.end() && !is_nothing(generators[g])) rays = cut(rays, generators[g], g);
  }
  std::vector<Whole> half_spaces;
  for (PolarRay& ray : rays) {
    // The half-space of all points, 0 x + d <= 0, belongs to the cone where all directions lie on one side of infinity.
    if (ray.ray[0] != 0 || ray.ray[1] != 0 || ray.ray[2] != 0) half_spaces.push_back(std::move(ray.ray));
  }
  return half_spaces;
}

}  // namespace gnomon::inverse
