#include "shading/image/irradiance_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/parallel.h"

namespace gnomon::image {
namespace {

constexpr double longest_edge = 1.0 / 24, shortest_edge = 1.0 / 1000;  ///< of the whole
constexpr double most_off = 1.0 / 400, most_apart = 1.0 / 24;          ///< of the largest irradiance
constexpr double inside = 0x1p-20;                                     ///< of the way to the middle

using CornerTriple = std::array<std::uint32_t, 3>;

Point3 on_the_way(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

double apart(const Point3& a, const Point3& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

/// The triangle in parts, where some edges have middles: that of edge k, from corner k to the next, or nothing.
void append_parts(std::vector<CornerTriple>& parts, CornerTriple corners,
                  std::array<std::optional<std::uint32_t>, 3> middles) {
  const auto count = std::ranges::count_if(middles, [](const auto& middle) { return middle.has_value(); });
  // Turned until the first edge has a middle, and of two the last one has none.
  while (count > 0 && (!middles[0] || (count == 2 && middles[2]))) {
    std::ranges::rotate(corners, corners.begin() + 1);
    std::ranges::rotate(middles, middles.begin() + 1);
  }
  const auto [a, b, c] = corners;
  if (count == 0) parts.push_back(corners);
  if (count == 1) parts.insert(parts.end(), {{a, *middles[0], c}, {*middles[0], b, c}});
  if (count >= 2) parts.push_back({*middles[0], b, *middles[1]});
  if (count == 2) parts.insert(parts.end(), {{a, *middles[0], *middles[1]}, {a, *middles[1], c}});
  if (count == 3) {
    parts.insert(
        parts.end(),
        {{a, *middles[0], *middles[2]}, {*middles[2], *middles[1], c}, {*middles[0], *middles[1], *middles[2]}});
  }
}

}  // namespace

/// Halves the edges of one root, round by round, as long as a judge wants it.
class IrradianceMesh::Halving {
 public:
  /// With a largest irradiance of 0 lengths alone count.
  Halving(Root& root, double whole, double largest, std::size_t worker)
      : root_(root), whole_(whole), largest_(largest), worker_(worker) {}

  Corner asked(const Point3& p) const { return {p, (*root_.irradiance)(worker_, on_the_way(p, root_.middle, inside))}; }

  void run() {
    for (std::size_t before = 0; before != root_.triangles.size();) {
      before = root_.triangles.size();
      std::vector<CornerTriple> parts;
      for (const CornerTriple& t : root_.triangles) {
        append_parts(parts, t, {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])});
      }
      root_.triangles = std::move(parts);
    }
  }

 private:
  /// Of an edge that is to be halved; both its triangles find the same one.
  std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = middles_.try_emplace(std::minmax(a, b));
    if (is_new) place->second = judged(std::min(a, b), std::max(a, b));
    return place->second;
  }

  std::optional<std::uint32_t> judged(std::uint32_t a, std::uint32_t b) {
    const Corner &first = root_.corners[a], &second = root_.corners[b];
    const double length = apart(first.point, second.point);
    const bool is_long = length > longest_edge * whole_;
    if (!is_long && (largest_ == 0 || length < shortest_edge * whole_)) return {};
    const Corner corner = asked(on_the_way(first.point, second.point, 0.5));
    if (!is_long && is_straight(first, corner, second)) return {};
    root_.corners.push_back(corner);
    return static_cast<std::uint32_t>(root_.corners.size() - 1);
  }

  bool is_straight(const Corner& a, const Corner& m, const Corner& b) const {
    const auto value = [&](const Corner& corner) { return std::min(corner.irradiance.value, largest_); };
    return std::fabs(value(m) - (value(a) + value(b)) / 2) <= most_off * largest_ &&
           std::fabs(value(a) - value(b)) <= most_apart * largest_;
  }

  Root& root_;
  double whole_, largest_;
  std::size_t worker_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<std::uint32_t>> middles_;
};

void IrradianceMesh::add(const MeshDrawing& drawing, IrradianceAt irradiance) {
  for (const ReceiverTriangle& triangle : drawing.triangles) {
    Root root{nullptr, {}, {}, {{0, 1, 2}}};
    for (const std::uint32_t v : triangle.vertices) root.corners.push_back({drawing.points[v], {}});
    const Point3 half = on_the_way(root.corners[0].point, root.corners[1].point, 0.5);
    root.middle = on_the_way(half, root.corners[2].point, 1.0 / 3);
    roots_.push_back(std::move(root));
    piece_of_.push_back(pieces_.size());
  }
  pieces_.push_back(std::move(irradiance));
}

void IrradianceMesh::begin(unsigned threads) {
  const double whole = extent();
  for_all(roots_.size(), threads, [&](std::size_t i, std::size_t worker) {
    Root& root = roots_[i];
    root.irradiance = &pieces_[piece_of_[i]];
    Halving halving(root, whole, 0, worker);
    for (Corner& corner : root.corners) corner = halving.asked(corner.point);
    halving.run();
  });
}

double IrradianceMesh::largest() const {
  double largest = 0;
  for (const Root& root : roots_) {
    for (const Corner& corner : root.corners) {
      if (std::isfinite(corner.irradiance.value)) largest = std::max(largest, corner.irradiance.value);
    }
  }
  return largest;
}

void IrradianceMesh::refine(double largest, unsigned threads) {
  if (largest == 0) return;
  const double whole = extent();
  for_all(roots_.size(), threads,
          [&](std::size_t i, std::size_t worker) { Halving(roots_[i], whole, largest, worker).run(); });
}

double IrradianceMesh::extent() const {
  Point3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Root& root : roots_) {
    for (const Corner& corner : root.corners) {
      const Point3& p = corner.point;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return roots_.empty() ? 0 : apart(low, high);
}

std::vector<IrradianceMesh::Corner> IrradianceMesh::corners() const {
  std::vector<Corner> all;
  for (const Root& root : roots_) all.insert(all.end(), root.corners.begin(), root.corners.end());
  return all;
}

std::vector<CornerTriple> IrradianceMesh::triangles() const {
  std::vector<CornerTriple> all;
  std::uint32_t first = 0;
  for (const Root& root : roots_) {
    for (const auto& [a, b, c] : root.triangles) all.push_back({first + a, first + b, first + c});
    first += static_cast<std::uint32_t>(root.corners.size());
  }
  return all;
}

}  // namespace gnomon::image
