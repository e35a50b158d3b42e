#include "geometry/spatial/convex_difference.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

using Point = ExactKernel::Point_2;

/// A part of the edge that is walked, in its direction.
struct Chord {
  Point from;
  Point to;
};

/// An edge of one of the polygons, from a to b, which is walked past the others.
class WalkedEdge {
 public:
  WalkedEdge(const Point& a, const Point& b)
      : a_(a), b_(b), by_x_(CGAL::compare_x(a, b) != CGAL::EQUAL), rises_(order(a, b) == CGAL::SMALLER) {}

  /// Of an edge of the whole: lies along an edge of something taken where nothing is left.
  void pass_taken(const ConvexLoop& taken) {
    const Meeting meeting = met_by(taken);
    if (meeting.points.size() == 2) cover(meeting.points[0], meeting.points[1]);
    if (meeting.points.size() == 1) touch(meeting.points[0]);
  }

  /// Of an edge of something taken, with nothing of the whole right of it along the whole's edges.
  void pass_whole(const ConvexLoop& whole) {
    const Meeting meeting = met_by(whole);
    if (!meeting.is_right && meeting.points.size() == 2) cover(meeting.points[0], meeting.points[1]);
  }

  /// Of an edge of something taken: past something else that is. Along an edge that both have, one of them counts.
  void pass_other(const ConvexLoop& other, bool other_counts) {
    const Meeting meeting = met_by(other);
    if (meeting.points.size() == 2 && (meeting.is_right || other_counts)) cover(meeting.points[0], meeting.points[1]);
    if (meeting.points.size() == 1 && meeting.is_right && !meeting.is_left) touch(meeting.points[0]);
  }

  /// One polygon covers all of it.
  bool is_gone() const { return is_gone_; }

  /// The parts that nothing covers, divided where they are touched.
  std::vector<Chord> uncovered() {
    std::sort(covers_.begin(), covers_.end(),
              [&](const Chord& c, const Chord& d) { return is_before(c.from, d.from); });
    std::vector<Chord> left;
    Point reached = a_;
    for (const Chord& cover : covers_) {
      if (is_before(reached, cover.from)) append(reached, cover.from, left);
      if (is_before(reached, cover.to)) reached = cover.to;
    }
    if (is_before(reached, b_)) append(reached, b_, left);
    return left;
  }

 private:
  CGAL::Comparison_result order(const Point& p, const Point& q) const {
    return by_x_ ? CGAL::compare_x(p, q) : CGAL::compare_y(p, q);
  }

  /// Of points on the edge's line: p comes strictly before q.
  bool is_before(const Point& p, const Point& q) const {
    return order(p, q) == (rises_ ? CGAL::SMALLER : CGAL::LARGER);
  }

  /// Where the edge's line meets the boundary of a convex polygon, two points at most, and on which sides of it that
  /// has corners.
  struct Meeting {
    std::vector<Point> points;
    bool is_left = false;
    bool is_right = false;
  };

  Meeting met_by(const ConvexLoop& loop) const {
    std::vector<CGAL::Orientation> sides;
    for (const Point& p : loop) sides.push_back(CGAL::orientation(a_, b_, p));
    Meeting meeting;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t next = k + 1 == loop.size() ? 0 : k + 1;
      meeting.is_left = meeting.is_left || sides[k] == CGAL::LEFT_TURN;
      meeting.is_right = meeting.is_right || sides[k] == CGAL::RIGHT_TURN;
      if (sides[k] == CGAL::COLLINEAR) meeting.points.push_back(loop[k]);
      if (sides[k] * sides[next] < 0) meeting.points.push_back(crossing(loop[k], loop[next]));
    }
    return meeting;
  }

  /// Notes a point of the edge's line, if it lies within the edge.
  void touch(const Point& p) {
    if (is_before(a_, p) && is_before(p, b_)) touched_.push_back(p);
  }

  Point crossing(const Point& p, const Point& q) const {
    const ExactKernel::Vector_2 way = b_ - a_, to_p = p - a_, to_q = q - a_;
    const ExactKernel::FT at_p = way.x() * to_p.y() - way.y() * to_p.x();
    const ExactKernel::FT at_q = way.x() * to_q.y() - way.y() * to_q.x();
    Point result = p + at_p / (at_p - at_q) * (q - p);
    result.exact();  // keeps expressions shallow
    return result;
  }

  void cover(Point from, Point to) {
    if (is_before(to, from)) std::swap(from, to);
    if (is_before(from, a_)) from = a_;
    if (is_before(b_, to)) to = b_;
    is_gone_ = is_gone_ || (from == a_ && to == b_);
    if (is_before(from, to)) covers_.push_back({from, to});
  }

  void append(Point from, const Point& to, std::vector<Chord>& chords) const {
    std::vector<Point> between;
    for (const Point& p : touched_) {
      if (is_before(from, p) && is_before(p, to)) between.push_back(p);
    }
    std::sort(between.begin(), between.end(), [&](const Point& p, const Point& q) { return is_before(p, q); });
    between.push_back(to);
    for (const Point& end : between) {
      if (!is_before(from, end)) continue;
      chords.push_back({from, end});
      from = end;
    }
  }

  Point a_;
  Point b_;
  bool by_x_;
  bool rises_;
  bool is_gone_ = false;
  std::vector<Chord> covers_;
  std::vector<Point> touched_;
};

template <class Visit>
void for_each_edge(const ConvexLoop& loop, const Visit& visit) {
  for (std::size_t k = 0; k < loop.size(); ++k) visit(WalkedEdge(loop[k], loop[k + 1 == loop.size() ? 0 : k + 1]));
}

}  // namespace

/// An edge of the whole bounds what is left where nothing taken has an edge along it. An edge of something taken
/// bounds it, the other way round, where what lies right of it is in the whole and not taken: so not along an edge of
/// the whole, not inside of something else that is taken, and not along an edge of it that runs the other way. Where
/// two run the same way the first counts. What touches an edge at a point from where the rest lies divides it.
std::vector<BoundaryEdge> convex_difference(const ConvexLoop& whole, std::span<const ConvexLoop> taken) {
  std::vector<BoundaryEdge> edges;
  for_each_edge(whole, [&](WalkedEdge edge) {
    for (const ConvexLoop& other : taken) edge.pass_taken(other);
    for (const Chord& chord : edge.uncovered()) edges.push_back({chord.from, chord.to});
  });
  std::size_t last = 0;  // that covered all of an edge: it is likely to cover all of the next
  for (std::size_t i = 0; i < taken.size(); ++i) {
    for_each_edge(taken[i], [&](WalkedEdge edge) {
      edge.pass_whole(whole);
      for (std::size_t n = 0; n < taken.size() && !edge.is_gone(); ++n) {
        const std::size_t j = (last + n) % taken.size();
        if (j != i) edge.pass_other(taken[j], j < i);
        if (edge.is_gone()) last = j;
      }
      if (edge.is_gone()) return;
      for (const Chord& chord : edge.uncovered()) edges.push_back({chord.to, chord.from});
    });
  }
  return edges;
}

}  // namespace gnomon
