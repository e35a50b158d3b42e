#pragma once

/// A polygon divided by arcs of conics. Private to geometry/.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/conics/near_curve.h"

namespace gnomon::conic {

/// A side of the polygon, with the polygon on its left, or an edge inside of it, with the polygon on both sides.
struct Side {
  FlatPoint from;
  FlatPoint to;
  std::uint32_t from_vertex = 0;
  std::uint32_t to_vertex = 0;
  std::uint32_t name = 0;
  bool is_inside = false;
};

/// An arc, some of which may lie outside of the polygon.
struct NamedArc {
  FlatArc arc;
  std::uint32_t name = 0;
};

/// The cells into which arcs divide a polygon.
///
/// Method:    every arc and every side lies on one of some curves, which are parted where they meet: at real roots on
///            both of their parameters, which are matched exactly. Around a point the curves' ends are put in order by
///            the sides on which they lie of each other, close by. Ends that lead nowhere are left out. What
///            does not hang together with the outer boundary is joined to it by a straight cut, which divides cells
///            that lie around it.
/// Exactness: exact; no number is rounded.
class CurveMap {
 public:
  static constexpr std::uint32_t nowhere = ~0U;

  struct Node {
    std::uint32_t vertex = nowhere;  ///< of the polygon, or ...
    std::uint32_t curve = nowhere;   ///< ... the point of a curve at this root
    RealRoot root{};
  };
  /// A part of a curve between two nodes, as its parameter grows.
  struct Piece {
    std::uint32_t curve = 0;
    RealRoot from;
    RealRoot to;
    std::uint32_t start = 0;
    std::uint32_t end = 0;
    std::uint32_t side = nowhere;      ///< index of the side that it is a part of
    bool runs_as_side = true;          ///< from the side's start to its end
    std::vector<std::uint32_t> names;  ///< of arcs, ascending; none of a cut
  };
  /// A piece as it is met with the cell on the left: 2 * piece forward, 2 * piece + 1 backward.
  using PieceUse = std::uint32_t;
  using Cell = std::vector<PieceUse>;

  /// Requires: sides that bound one polygon, or one with holes; pieces of curves do not overlap sides.
  CurveMap(std::span<const Side> sides, std::span<const NamedArc> arcs);

  /// False where the same conic came with parameters that cannot be brought together.
  bool is_complete() const { return is_complete_; }

  const std::vector<FlatCurve>& curves() const { return curves_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Each bounded by one cycle.
  const std::vector<Cell>& cells() const { return cells_; }

  /// A point inside of a cell.
  FlatPoint inner_point(std::size_t cell) const;

 private:
  struct Stretch {
    Rational from;
    Rational to;
    std::uint32_t side = nowhere;
    bool runs_as_side = true;
    std::optional<std::uint32_t> name;  ///< of an arc
  };
  struct Break {
    RealRoot root;
    std::uint32_t node = 0;
  };
  struct End {
    std::uint32_t piece = 0;
    int way = 1;  ///< in which the parameter changes as one leaves the node
  };

  void add_side(const Side& side, std::uint32_t index);
  void add_arc(const NamedArc& arc);
  std::uint32_t curve_like(const FlatCurve& curve);
  static std::optional<Rational> parameter_on(const FlatCurve& own, const FlatCurve& other, const Rational& at);
  static std::optional<Range> range_on(const FlatCurve& own, const FlatArc& arc);
  std::optional<Range> range_after_moving_pole(std::uint32_t curve, const FlatArc& arc);
  void find_breaks();
  void find_meetings(std::uint32_t a, std::uint32_t b);
  bool is_on_stretch(std::uint32_t curve, RealRoot& root) const;
  std::uint32_t new_node();
  void unite_equal_breaks();
  void make_pieces();
  void make_pieces_of(std::uint32_t curve);
  bool is_in_polygon(const FlatPoint& p) const;
  std::optional<bool> is_certainly_in_polygon(const FlatPoint& p) const;
  bool may_meet(std::uint32_t a, std::uint32_t b) const;
  Range hull(std::uint32_t curve) const;
  bool is_clear(const FlatPoint& start, const FlatPoint& way) const;
  void drop_loose_ends();
  bool add_cuts();
  void make_cells();
  std::vector<End> ordered(std::vector<End> ends) const;
  int side_of(const End& line, const End& other, int other_way) const;
  FlatPoint point_near(const End& end, int way, const FlatCurve& other) const;

  std::vector<Side> sides_;
  bool is_complete_ = true;
  std::vector<FlatCurve> curves_;
  std::vector<NearCurve> near_;           ///< the same
  std::vector<NearPoint> near_vertices_;  ///< of each side the start, and after all of them their ends
  std::map<std::vector<Integer>, std::uint32_t> curve_of_form_;
  std::vector<std::vector<Stretch>> stretches_;  ///< of each curve
  std::vector<std::vector<Break>> breaks_;       ///< of each curve, ascending
  std::vector<Node> nodes_;
  std::vector<Piece> pieces_;
  std::vector<Cell> cells_;
};

}  // namespace gnomon::conic
