#include "gnomon/flatland_partition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/partition_data.h"
#include "geometry/planar/viewpoint.h"
#include "geometry/planar/visibility_query.h"

namespace gnomon::planar {
namespace {

/// A number and the double nearest to it, which decides against every other double.
struct Abscissa {
  Rational exact;
  double near = 0;
};

bool is_before(const Abscissa& a, double x) {
  return a.near < x || (a.near == x && a.exact < Rational(x));
}

/// The line y = slope x + height of an edge that is not upright, and the faces on both sides.
struct Slanted {
  Rational slope, height;
  double near_slope = 0, near_height = 0;
  std::uint32_t below = nowhere, above = nowhere;

  Rational at(const Rational& x) const { return slope * x + height; }
};

/// +1 if the point lies above the line, 0 on it, -1 below.
int side_of(const Slanted& line, const Point2& p) {
  const double rise = line.near_slope * p.x;
  const double above = p.y - (rise + line.near_height);
  // Both numbers of the line are rounded once, and so are the product and the two sums: 5 half units of the product, 3
  // of the height, 1 of y. What underflows is less than `tiny`, in the slope times x.
  constexpr double tiny = std::numeric_limits<double>::min();
  const double magnitude = std::fabs(rise) + std::fabs(line.near_height) + std::fabs(p.y);
  const double error = 8 * 0x1p-53 * magnitude + tiny * (2 + std::fabs(p.x));
  if (above > error) return 1;
  if (above < -error) return -1;
  const Rational y = p.y;
  return y.compare(line.at(p.x));
}

/// An edge on an upright line; no end where it comes from or goes to infinity.
struct Upright {
  std::optional<Rational> low, high;
  std::uint32_t left = nowhere, right = nowhere;
};

/// What lies on one of the upright lines: in order upward.
struct Column {
  std::vector<Rational> vertices;
  std::vector<Upright> edges;

  bool meets(const Rational& y) const {
    if (std::ranges::binary_search(vertices, y)) return true;
    const auto next = std::ranges::find_if(edges, [&](const Upright& edge) { return edge.low && *edge.low > y; });
    if (next == edges.begin()) return false;
    const Upright& last = *std::prev(next);
    return !last.high || *last.high >= y;
  }
};

}  // namespace

/// Slab i lies left of column i and right of the one before; the last slab has no column.
class PartitionLocation::Slabs {
 public:
  explicit Slabs(const Partition::Data& data) : data_(data) {
    make_columns();
    std::vector<std::vector<std::uint32_t>> starts(columns_.size() + 1);
    for (std::size_t i = 0; i < data.edges.size(); ++i) add_edge(i, starts);
    for (Column& column : columns_) {
      std::ranges::sort(column.vertices);
      std::ranges::sort(column.edges, {}, &Upright::low);
    }
    make_orders(starts);
    make_bottoms();
  }

  std::uint32_t face(const Point2& p) const {
    const auto found = std::ranges::partition_point(places_, [&](const Abscissa& a) { return is_before(a, p.x); });
    const auto slab = static_cast<std::size_t>(found - places_.begin());
    const bool on_column = found != places_.end() && found->near == p.x && found->exact == Rational(p.x);
    if (on_column && columns_[slab].meets(p.y)) return nowhere;
    // On the column the order still holds, up to edges that meet there.
    const auto& order = orders_[slab];
    const auto next = std::ranges::partition_point(order, [&](std::uint32_t i) { return side_of(lines_[i], p) > 0; });
    if (next != order.end() && side_of(lines_[*next], p) == 0) return nowhere;
    return next == order.begin() ? bottoms_[slab] : lines_[*std::prev(next)].above;
  }

 private:
  static bool is_upright(const std::array<ExactPoint, 2>& points) { return points[0].x == points[1].x; }

  void make_columns() {
    std::vector<Rational> all;
    for (const ExactPoint& p : data_.exact_vertices) all.push_back(p.x);
    for (const auto& points : data_.edge_points) {
      if (is_upright(points)) all.push_back(points[0].x);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const Rational& x : all) places_.push_back({x, nearest_double(x)});
    columns_.resize(places_.size());
    for (const ExactPoint& p : data_.exact_vertices) columns_[column(p.x)].vertices.push_back(p.y);
  }

  std::size_t column(const Rational& x) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(places_, x, {}, &Abscissa::exact) - places_.begin());
  }

  void add_edge(std::size_t i, std::vector<std::vector<std::uint32_t>>& starts) {
    const PartitionEdge& edge = data_.edges[i];
    const auto& [a, b] = data_.edge_points[i];
    if (is_upright(data_.edge_points[i])) return add_upright(edge, a, b);
    const bool forward = a.x < b.x;
    Slanted line;
    line.slope = (b.y - a.y) / (b.x - a.x);
    line.height = a.y - line.slope * a.x;
    line.near_slope = nearest_double(line.slope), line.near_height = nearest_double(line.height);
    line.below = forward ? edge.right : edge.left, line.above = forward ? edge.left : edge.right;
    const std::uint32_t first = forward ? edge.source : edge.target, last = forward ? edge.target : edge.source;
    starts[first == nowhere ? 0 : column(data_.exact_vertices[first].x) + 1].push_back(
        static_cast<std::uint32_t>(lines_.size()));
    last_slabs_.push_back(last == nowhere ? columns_.size() : column(data_.exact_vertices[last].x));
    lines_.push_back(std::move(line));
  }

  void add_upright(const PartitionEdge& edge, const ExactPoint& a, const ExactPoint& b) {
    std::optional<Rational> low, high;
    if (edge.source != nowhere) low = a.y;
    if (edge.target != nowhere) high = b.y;
    const bool upward = a.y < b.y;
    if (!upward) std::swap(low, high);
    columns_[column(a.x)].edges.push_back(
        {low, high, upward ? edge.left : edge.right, upward ? edge.right : edge.left});
  }

  Rational place_inside(std::size_t slab) const {
    if (places_.empty()) return 0;
    if (slab == 0) return places_.front().exact - 1;
    if (slab == places_.size()) return places_.back().exact + 1;
    return (places_[slab - 1].exact + places_[slab].exact) / 2;
  }

  /// From each slab to the next few edges end and begin.
  void make_orders(const std::vector<std::vector<std::uint32_t>>& starts) {
    std::vector<std::uint32_t> order;
    for (std::size_t slab = 0; slab < starts.size(); ++slab) {
      std::erase_if(order, [&](std::uint32_t i) { return last_slabs_[i] < slab; });
      const Rational x = place_inside(slab);
      for (const std::uint32_t added : starts[slab]) {
        const Rational y = lines_[added].at(x);
        const auto next = std::ranges::partition_point(order, [&](std::uint32_t i) { return lines_[i].at(x) < y; });
        order.insert(next, added);
      }
      orders_.push_back(order);
    }
  }

  /// The lowest face of each slab; of one without edges, what it shares with a neighbour.
  void make_bottoms() {
    std::vector<std::optional<std::uint32_t>> known(orders_.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!orders_[i].empty()) {
        known[i] = lines_[orders_[i].front()].below;
      } else if (i > 0) {
        known[i] = columns_[i - 1].edges.empty() ? known[i - 1] : columns_[i - 1].edges.front().right;
      }
    }
    for (std::size_t i = known.size() - 1; i-- > 0;) {
      if (!known[i]) known[i] = columns_[i].edges.empty() ? known[i + 1] : columns_[i].edges.front().left;
    }
    for (const auto& face : known) bottoms_.push_back(face.value_or(0));
  }

  const Partition::Data& data_;
  std::vector<Abscissa> places_;  ///< of the columns
  std::vector<Column> columns_;
  std::vector<Slanted> lines_;
  std::vector<std::size_t> last_slabs_;             ///< that each line crosses
  std::vector<std::vector<std::uint32_t>> orders_;  ///< of the lines across each slab, upward
  std::vector<std::uint32_t> bottoms_;
};

PartitionLocation::PartitionLocation(const Partition& partition)
    : partition_(partition), slabs_(std::make_shared<const Slabs>(partition_.data())) {}

std::uint32_t PartitionLocation::face(const Point2& point) const {
  return slabs_->face(point);
}

Region PartitionLocation::region(const Point2& point) const {
  const std::uint32_t in = face(point);
  return in == nowhere ? partition_.visibility().region(point) : partition_.faces()[in].region;
}

VisibleLight PartitionLocation::visible_light(const Point2& point) const {
  const std::uint32_t in = face(point);
  if (in == nowhere) return partition_.visibility().visible_light(point);
  const PartitionFace& found = partition_.faces()[in];
  if (found.region == Region::umbra) return {Region::umbra, {}};
  if (found.visible.empty()) return partition_.visibility().visible_light(point);
  const Viewpoint from(point);
  const VisibilityQuery query(partition_.visibility(), from);
  VisibleLight seen{found.region, found.visible};
  for (VisibleInterval& interval : seen.intervals) {
    interval = {query.named_end(interval.from.name), query.named_end(interval.to.name)};
  }
  return seen;
}

}  // namespace gnomon::planar
