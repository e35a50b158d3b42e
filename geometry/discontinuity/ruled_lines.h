#pragma once

/// The lines of sight that meet three edges, in intervals: what is asked of them are signs of polynomials of a
/// parameter t. Private to this folder.

#include <array>
#include <optional>

#include "geometry/conics/flat_curve.h"
#include "geometry/discontinuity/silhouette_edges.h"

namespace gnomon::event {

/// A polynomial of degree 3 at most, by powers of t. Requires of all functions: the rounding mode is protected.
using NearPolynomial = std::array<Interval, 4>;

/// The sign that a polynomial has between two parameters; 0 unless its Bernstein coefficients all have it.
int certain_sign(const NearPolynomial& f, const Interval& from, const Interval& to);

/// Of two polynomials whose degrees add up to 3 at most.
NearPolynomial product(const NearPolynomial& f, const NearPolynomial& g);
NearPolynomial difference(const NearPolynomial& f, const NearPolynomial& g);

/// A flat receiver's plane: the point (w, x, y) is w origin + x along_x + y along_y.
struct NearFrame {
  PointEnclosure origin;
  PointEnclosure along_x;
  PointEnclosure along_y;

  explicit NearFrame(const ReceiverPlane& plane);
};

/// The lines from points p of a receiver's plane through points q of the first of three edges, the base, that meet all
/// three. Both points are homogeneous, their weights of any sign.
class RuledLines {
 public:
  /// Edges no two of which lie in one plane: t is the share of the base at which q lies.
  RuledLines(const std::array<const SilhouetteEdge*, 3>& edges, const NearFrame& frame);
  /// Two edges that cross, after the base: p runs along a straight line, whose parameter t is. The plane through p and
  /// `parting`, one of the two, tells q.
  RuledLines(const std::array<const SilhouetteEdge*, 3>& edges, const SilhouetteEdge& parting,
             const conic::FlatCurve& line, const NearFrame& frame);

  const std::array<const SilhouetteEdge*, 3>& edges() const { return edges_; }
  bool is_share_of_base() const { return is_share_of_base_; }

  /// Flat coordinates of p between two parameters; nothing if they may lie at infinity.
  std::optional<FlatEnclosure> points(const Interval& t) const;

  const NearPolynomial& point_weight() const { return flat_[0]; }
  const NearPolynomial& base_weight() const { return base_weight_; }
  /// They vanish where q is the base's a or b; q lies between them where they have different signs.
  const std::array<NearPolynomial, 2>& base_ends() const { return base_ends_; }

  /// The volume of p, a, b, q for the line through a and b, with both weights as factors.
  NearPolynomial side(const NearLine& line) const;
  /// The heights of p and of q, each with its weight as a factor.
  NearPolynomial height_of_point(const NearPlane& plane) const;
  NearPolynomial height_of_base(const NearPlane& plane) const;
  /// The way in which an edge's plane through p is crossed by another edge, from its a to its b; with p's weight.
  NearPolynomial crossing(const NearLine& edge, const NearLine& other) const;

 private:
  using Path = std::array<PointEnclosure, 4>;  ///< of a vector, by powers of t

  void find_lines(const NearFrame& frame);

  std::array<const SilhouetteEdge*, 3> edges_;
  bool is_share_of_base_;
  std::array<NearPolynomial, 3> flat_;  ///< w, x and y of p
  std::array<NearPolynomial, 2> base_ends_;
  NearPolynomial base_weight_;
  Path point_;
  Path base_;
  Path direction_;
  Path moment_;
};

}  // namespace gnomon::event
