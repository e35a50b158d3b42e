#include "shading/illumination/first_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/rounding.h"
#include "geometry/numbers/vector3.h"

namespace gnomon::illumination {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_intersections_tag>>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;
using FlatPlace = std::pair<double, double>;
using ExactPlace = std::pair<Rational, Rational>;

/// The plane of a receiver over two of the coordinates.
class Sheet {
 public:
  explicit Sheet(const std::vector<Point3>& ring) {
    const PolygonPlane plane = polygon_plane(ring).value();
    axis_ = plane.dropped_axis;
    origin_ = ring[plane.vertices[0]];
    normal_ = cross(step(origin_, ring[plane.vertices[1]]), step(origin_, ring[plane.vertices[2]]));
  }

  ExactPlace place(const ExactVector& p) const {
    const auto [i, j, k] = axes();
    return {p[i], p[j]};
  }

  Point3 lifted(const FlatPlace& at) const {
    const auto [i, j, k] = axes();
    const double high = normal_[i] * (at.first - coordinate(i)) + normal_[j] * (at.second - coordinate(j));
    std::array<double, 3> p{};
    p[i] = at.first;
    p[j] = at.second;
    p[k] = coordinate(k) - (high == 0 ? 0 : high / normal_[k]);
    return {p[0], p[1], p[2]};
  }

  /// True if what runs counterclockwise seen from the front does so in the two coordinates.
  bool faces_up() const { return normal_[static_cast<std::size_t>(axis_)] > 0; }

 private:
  std::array<std::size_t, 3> axes() const {
    const auto k = static_cast<std::size_t>(axis_);
    return {(k + 1) % 3, (k + 2) % 3, k};
  }
  double coordinate(std::size_t axis) const { return axis == 0 ? origin_.x : axis == 1 ? origin_.y : origin_.z; }

  int axis_ = 0;
  Point3 origin_;
  Vector3<double> normal_;
};

double turn(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c) {
  return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

class Maker {
 public:
  explicit Maker(const Outline& outline) : outline_(outline), sheet_(rounded(outline.rings.front())) {}

  FirstTriangles made() {
    insert_all();
    std::map<Face, std::optional<std::uint32_t>> receivers;
    for (const Face face : triangulation_.finite_face_handles()) spread(face, receivers);
    for (const Face face : triangulation_.finite_face_handles()) {
      if (const auto receiver = receivers.at(face)) append(face, *receiver);
    }
    return std::move(result_);
  }

 private:
  using Line = std::vector<Vertex>;

  void insert_all() {
    std::vector<std::pair<Triangulation::Constraint_id, std::uint8_t>> lines;
    const auto insert = [&](const ExactVector& a, const ExactVector& b, std::uint8_t order) {
      const Vertex from = vertex(a), to = vertex(b);
      if (from == to) return;
      const auto id = triangulation_.insert_constraint(from, to);
      if (id != Triangulation::Constraint_id()) lines.emplace_back(id, order);
    };
    for (const std::vector<ExactVector>& ring : outline_.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) insert(ring[k], ring[(k + 1) % ring.size()], border);
    }
    for (const Trace& trace : outline_.traces) insert(trace.a, trace.b, trace.order);
    for (const ExactVector& p : outline_.corners) vertex(p);
    for (const auto& [id, order] : lines) mark(id, order);
  }

  /// Among the orders of an edge the border stands beside the others, which may run along it.
  static constexpr std::uint8_t border = 0x80;

  void mark(Triangulation::Constraint_id id, std::uint8_t order) {
    auto v = triangulation_.vertices_in_constraint_begin(id);
    for (auto next = std::next(v); next != triangulation_.vertices_in_constraint_end(id); v = next++) {
      const auto [place, is_new] = orders_.try_emplace(std::minmax(*v, *next), smooth);
      const auto is_border = static_cast<std::uint8_t>((place->second | order) & border);
      const auto lower = std::min<std::uint8_t>(place->second & 0x7F, order == border ? smooth : order);
      place->second = is_border | lower;
    }
  }

  static Point3 rounded(const ExactVector& p) {
    return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
  }

  static std::vector<Point3> rounded(const std::vector<ExactVector>& ring) {
    std::vector<Point3> points;
    for (const ExactVector& p : ring) points.push_back(rounded(p));
    return points;
  }

  Vertex vertex(const ExactVector& p) {
    const auto [found, is_new] = vertices_.try_emplace(sheet_.place(p));
    if (is_new) {
      found->second = triangulation_.insert({Kernel::FT(found->first.first), Kernel::FT(found->first.second)});
      known_.try_emplace(found->second, rounded(p));
    }
    return found->second;
  }

  std::uint8_t order_of(Face face, int side) const {
    const auto found =
        orders_.find(std::minmax(face->vertex(Triangulation::ccw(side)), face->vertex(Triangulation::cw(side))));
    return found == orders_.end() ? smooth : found->second;
  }

  /// Gives all triangles that no border parts from this one the receiver that holds the middle of the widest of them;
  /// none outside.
  void spread(Face first, std::map<Face, std::optional<std::uint32_t>>& receivers) {
    if (receivers.contains(first)) return;
    std::vector<Face> all{first};
    receivers[first] = std::nullopt;
    bool is_outside = false;
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (int i = 0; i < 3; ++i) {
        if (order_of(all[k], i) & border) continue;
        const Face next = all[k]->neighbor(i);
        is_outside = is_outside || triangulation_.is_infinite(next);
        if (!triangulation_.is_infinite(next) && receivers.try_emplace(next).second) all.push_back(next);
      }
    }
    if (is_outside) return;
    const Face widest = *std::ranges::max_element(all, {}, [&](Face f) { return std::fabs(double_area(f)); });
    const std::optional<std::uint32_t> receiver = ring_around(middle(widest));
    for (const Face face : all) receivers[face] = receiver;
  }

  FlatPlace place(Vertex v) {
    const auto [found, is_new] = places_.try_emplace(v);
    if (is_new) found->second = {CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())};
    return found->second;
  }

  double double_area(Face face) { return turn(place(face->vertex(0)), place(face->vertex(1)), place(face->vertex(2))); }

  FlatPlace middle(Face face) {
    FlatPlace sum{0, 0};
    for (int k = 0; k < 3; ++k) {
      const FlatPlace at = place(face->vertex(k));
      sum = {sum.first + at.first / 3, sum.second + at.second / 3};
    }
    return sum;
  }

  std::optional<std::uint32_t> ring_around(const FlatPlace& at) const {
    const double side = sheet_.faces_up() ? 1 : -1;
    for (std::uint32_t r = 0; r < outline_.rings.size(); ++r) {
      const std::vector<ExactVector>& ring = outline_.rings[r];
      bool is_in = true;
      for (std::size_t k = 0; k < ring.size() && is_in; ++k) {
        // What is rounded is far from the middle of the widest triangle.
        is_in = side * turn(near_place(ring[k]), near_place(ring[(k + 1) % ring.size()]), at) >= 0;
      }
      if (is_in) return r;
    }
    return std::nullopt;
  }

  FlatPlace near_place(const ExactVector& p) const {
    const ExactPlace at = sheet_.place(p);
    return {at.first.convert_to<double>(), at.second.convert_to<double>()};
  }

  std::uint32_t number(Vertex v) {
    const auto [found, is_new] = numbers_.try_emplace(v, static_cast<std::uint32_t>(result_.points.size()));
    if (is_new) {
      const auto known = known_.find(v);
      result_.points.push_back(known == known_.end() ? sheet_.lifted(place(v)) : known->second);
    }
    return found->second;
  }

  void append(Face face, std::uint32_t receiver) {
    FirstTriangle t{{}, {}, receiver};
    for (int k = 0; k < 3; ++k) {
      // Side k + 2 runs from corner k to the next.
      t.corners[static_cast<std::size_t>(k)] = number(face->vertex(k));
      t.orders[static_cast<std::size_t>(k)] = order_of(face, (k + 2) % 3) & 0x7F;
    }
    if (!sheet_.faces_up()) {
      std::swap(t.corners[1], t.corners[2]);
      std::swap(t.orders[0], t.orders[2]);
    }
    result_.triangles.push_back(t);
  }

  const Outline& outline_;
  Sheet sheet_;
  Triangulation triangulation_;
  std::map<ExactPlace, Vertex> vertices_;  ///< of what is given
  std::map<Vertex, Point3> known_;
  std::map<std::pair<Vertex, Vertex>, std::uint8_t> orders_;
  std::map<Vertex, FlatPlace> places_;
  std::map<Vertex, std::uint32_t> numbers_;
  FirstTriangles result_;
};

}  // namespace

FirstTriangles first_triangles(const Outline& outline) {
  return Maker(outline).made();
}

}  // namespace gnomon::illumination
