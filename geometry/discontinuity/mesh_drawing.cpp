#include <algorithm>
#include <map>
#include <utility>

#include "geometry/discontinuity/face_triangulation.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

using event::FaceTriangulation;

/// How far an arc strays from its chord, between two values of the parameter: the height of the middle Bezier point
/// times w / (1 + w). From exact differences in plain doubles, told a little larger than their rounding.
double arc_height(const FaceArc& arc, const Rational& from, const Rational& to) {
  const auto [p, q, r] = conic::bezier_points(arc.curve, from, to);
  const auto difference = [](const auto& b, const auto& a, std::size_t k) {
    return nearest_double(Rational(b[k] / b[0] - a[k] / a[0]));
  };
  const double chord_x = difference(r, p, 1), chord_y = difference(r, p, 2), length = std::hypot(chord_x, chord_y);
  const double x = difference(q, p, 1), y = difference(q, p, 2);
  const double weight = nearest_root(Rational(q[0] * q[0] / (p[0] * r[0])));
  const double height = length > 0 ? std::fabs(x * chord_y - y * chord_x) / length : std::hypot(x, y);
  return 1.0001 * height * weight / (1 + weight);
}

/// A mesh on its receiver's plane, arcs as chords.
class FlatDrawing {
 public:
  FlatDrawing(const ReceiverMesh::Data& data, double tolerance) : data_(data), tolerance_(tolerance) {
    for (std::uint32_t v = 0; v < data.vertex_count(); ++v) points_.push_back(data.point(v));
    for (const MeshEdge& edge : data.edges) lines_.push_back(line(edge));
  }

  const std::vector<event::FlatPoint>& points() const { return points_; }
  double chord_error() const { return chord_error_; }
  std::vector<std::vector<std::uint32_t>> take_lines() { return std::move(lines_); }

  /// Whether a chord was left out because it crosses another or an edge.
  bool has_crossing() const { return has_crossing_; }

  std::vector<ReceiverTriangle> triangles() {
    FaceTriangulation triangulation;
    std::vector<FaceTriangulation::Vertex_handle> handles;
    for (const event::FlatPoint& p : points_) {
      handles.push_back(triangulation.insert(event::triangulation_point(p)));
      handles.back()->info() = static_cast<std::uint32_t>(handles.size() - 1);
    }
    // Straight edges first: chords that cross one are left out.
    for (const bool is_arc : {false, true}) {
      for (std::size_t e = 0; e < lines_.size(); ++e) {
        if ((data_.edges[e].arc != MeshEdge::nowhere) == is_arc) insert(lines_[e], handles, triangulation);
      }
    }
    return labelled(triangulation);
  }

 private:
  void insert(const std::vector<std::uint32_t>& line, const std::vector<FaceTriangulation::Vertex_handle>& handles,
              FaceTriangulation& triangulation) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      // Vertices that are told apart may be one to 2^-100.
      const auto from = handles[line[k]], to = handles[line[k + 1]];
      if (from == to) continue;
      try {
        triangulation.insert_constraint(from, to);
      } catch (const FaceTriangulation::Intersection_of_constraints_exception&) {
        has_crossing_ = true;
      }
    }
  }

  struct Left {
    std::uint32_t face = MeshEdge::nowhere;
    bool is_arc = false;
  };

  std::vector<std::uint32_t> line(const MeshEdge& edge) {
    std::vector<std::uint32_t> result{edge.source};
    if (edge.arc != MeshEdge::nowhere) {
      const FaceArc& arc = data_.arcs[edge.arc];
      append_points(arc, arc.from.high, arc.to.low, 0, result);
    }
    result.push_back(edge.target);
    return result;
  }

  /// Points of an arc between two of its parameters that stay away from its chords.
  void append_points(const FaceArc& arc, const Rational& from, const Rational& to, int halvings,
                     std::vector<std::uint32_t>& line) {
    constexpr int most_halvings = 16;
    const double height = arc_height(arc, from, to);
    if (height <= tolerance_ || halvings == most_halvings) {
      chord_error_ = std::max(chord_error_, height);
      return;
    }
    const Rational middle = short_number_between(from, to);
    append_points(arc, from, middle, halvings + 1, line);
    line.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(*arc.curve.at(middle));
    append_points(arc, middle, to, halvings + 1, line);
  }

  std::vector<ReceiverTriangle> labelled(const FaceTriangulation& triangulation) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Left> left;
    for (std::size_t e = 0; e < lines_.size(); ++e) {
      const MeshEdge& edge = data_.edges[e];
      const bool is_arc = edge.arc != MeshEdge::nowhere;
      for (std::size_t k = 0; k + 1 < lines_[e].size(); ++k) {
        left[{lines_[e][k], lines_[e][k + 1]}] = {edge.left, is_arc};
        left[{lines_[e][k + 1], lines_[e][k]}] = {edge.right, is_arc};
      }
    }
    std::map<FaceTriangulation::Face_handle, std::uint32_t> face_of;
    for (auto t = triangulation.finite_faces_begin(); t != triangulation.finite_faces_end(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const auto found = left.find(event::side_of(t, i));
        if (found != left.end() && found->second.face != MeshEdge::nowhere)
          event::spread(t, found->second.face, face_of);
      }
    }
    std::vector<ReceiverTriangle> result;
    for (auto t = triangulation.finite_faces_begin(); t != triangulation.finite_faces_end(); ++t) {
      const auto found = face_of.find(t);
      if (found == face_of.end()) continue;
      bool is_at_arc = false;
      for (int i = 0; i < 3; ++i) {
        const auto at = left.find(event::side_of(t, i));
        is_at_arc = is_at_arc || (at != left.end() && at->second.is_arc);
      }
      result.push_back({{t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()}, found->second, is_at_arc});
    }
    return result;
  }

  const ReceiverMesh::Data& data_;
  double tolerance_;
  std::vector<event::FlatPoint> points_;
  std::vector<std::vector<std::uint32_t>> lines_;
  double chord_error_ = 0;
  bool has_crossing_ = false;
};

double width_of(std::span<const Point3> points) {
  Box3 box{points[0], points[0]};
  for (const Point3& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
}

Point3 lifted(const event::ReceiverPlane& plane, const event::FlatPoint& p) {
  const ExactVector q = plane.spatial(p);
  return {nearest_double(q.x), nearest_double(q.y), nearest_double(q.z)};
}

}  // namespace

std::vector<MeshArc> ReceiverMesh::arcs() const {
  std::vector<MeshArc> result;
  for (const FaceArc& arc : data_->arcs) {
    const auto points = conic::bezier_points(arc.curve, arc.from.high, arc.to.low);
    MeshArc& made = result.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [w, x, y] = points[k];
      made.points[k] = lifted(data_->plane, {Rational(x / w), Rational(y / w)});
    }
    const Rational &w0 = points[0][0], &w1 = points[1][0], &w2 = points[2][0];
    made.weight = nearest_root(Rational(w1 * w1 / (w0 * w2)));
  }
  return result;
}

MeshDrawing ReceiverMesh::drawing() const {
  MeshDrawing result;
  // A flat length is stretched when it is lifted to the receiver's plane, at most by the square root of 3.
  const double stretch = nearest_root(data_->plane.squared_stretch());
  const double width = width_of(vertices());
  double tolerance = width / 4096 / stretch;
  for (int trial = 0;; ++trial, tolerance /= 16) {
    constexpr int most_trials = 2;
    FlatDrawing flat(*data_, tolerance);
    result.triangles = flat.triangles();
    if (flat.has_crossing() && trial < most_trials) continue;
    result.chords_cross = flat.has_crossing();
    result.lines = flat.take_lines();
    result.chord_error = 1.0001 * stretch * flat.chord_error();
    for (const event::FlatPoint& p : flat.points()) result.points.push_back(lifted(data_->plane, p));
    return result;
  }
}

}  // namespace gnomon
