#include "shading/image/vertex_normals.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "shading/vector.h"

namespace gnomon::image {
namespace {

using shading::Vector;

Vector vector(const Point3& p) {
  return {p.x, p.y, p.z};
}

Vector between(const Point3& a, const Point3& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}

double angle(const Vector& a, const Vector& b) {
  return std::atan2(shading::length(cross(a, b)), dot(a, b));
}

double area(const Facet& facet) {
  const auto& p = facet.shape.points();
  Vector sum{0, 0, 0};
  for (std::size_t k = 2; k < p.size(); ++k) sum = sum + cross(between(p[0], p[k - 1]), between(p[0], p[k]));
  return shading::length(sum) / 2;
}

/// A facet at a corner, and how much its normal counts.
struct Share {
  const Facet* facet;
  double weight;
};

double weight_at(const Facet& facet, std::size_t corner, VertexNormals how) {
  if (how == VertexNormals::equal) return 1;
  if (how == VertexNormals::area) return area(facet);
  const auto& p = facet.shape.points();
  const std::size_t n = p.size();
  return angle(between(p[corner], p[(corner + 1) % n]), between(p[corner], p[(corner + n - 1) % n]));
}

using Place = std::tuple<double, double, double>;

Place place(const Point3& p) {
  return {p.x, p.y, p.z};
}

using SharesAt = std::map<Place, std::vector<Share>>;

SharesAt shares_of(std::span<const Facet> facets, VertexNormals how) {
  SharesAt shares;
  for (const Facet& facet : facets) {
    const auto& p = facet.shape.points();
    for (std::size_t k = 0; k < p.size(); ++k) shares[place(p[k])].push_back({&facet, weight_at(facet, k, how)});
  }
  return shares;
}

/// Of no length where the normals around cancel.
Vector mean_normal(const Facet& facet, const std::vector<Share>& shares, double crease) {
  Vector sum{0, 0, 0};
  for (const Share& share : shares) {
    const bool is_smooth = crease >= 180 || share.facet == &facet ||
                           angle(vector(facet.normal), vector(share.facet->normal)) <= crease * std::numbers::pi / 180;
    if (is_smooth) sum = sum + share.weight * vector(share.facet->normal);
  }
  return sum;
}

}  // namespace

std::size_t add_vertex_normals(std::span<Facet> facets, const Smoothness& smoothness) {
  if (smoothness.normals == VertexNormals::flat || smoothness.normals == VertexNormals::file) return 0;
  const SharesAt shares = shares_of(facets, smoothness.normals);
  std::size_t flat = 0;
  std::vector<std::vector<Point3>> normals(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const Point3& corner : facets[f].shape.points()) {
      const Vector mean = mean_normal(facets[f], shares.at(place(corner)), smoothness.crease);
      const double size = shading::length(mean);
      if (!(size > 0)) break;
      const Vector unit = 1 / size * mean;
      normals[f].push_back({unit.x, unit.y, unit.z});
    }
    if (normals[f].size() == facets[f].shape.points().size()) continue;
    normals[f].clear();
    ++flat;
  }
  for (std::size_t f = 0; f < facets.size(); ++f) facets[f].vertex_normals = std::move(normals[f]);
  return flat;
}

}  // namespace gnomon::image
