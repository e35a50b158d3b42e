#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "geometry/bodies/boxes.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/event_arrangement.h"
#include "geometry/planar/partition_data.h"
#include "geometry/planar/visibility_query.h"
#include "gnomon/errors.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::planar {
namespace {

using Point = ExactKernel::Point_2;
using Face = EventArrangement::Face_handle;
using Halfedge = EventArrangement::Halfedge_handle;
using Vertex = EventArrangement::Vertex_handle;

bool same_names(const VisibleLight& a, const VisibleLight& b) {
  return std::ranges::equal(a.intervals, b.intervals, [](const VisibleInterval& one, const VisibleInterval& other) {
    return one.from.name == other.from.name && one.to.name == other.to.name;
  });
}

/// From the arrangement to the partition: labels for its faces, edges where labels differ, faces between these edges.
class Builder {
 public:
  Builder(const LightVisibility& visibility, const PartitionOptions& options)
      : options_(options), data_{visibility, options.box, {}, {}, {}, {}, {}, {}} {
    build_arrangement(visibility.flatland(), options, arrangement_, data_.names);
  }

  Partition::Data result() {
    label_faces();
    choose_edges();
    number_faces();
    choose_vertices();
    make_edges();
    make_cycles();
    make_points();
    return std::move(data_);
  }

 private:
  VisibleLight visible_from(const Point& point) const {
    const Viewpoint from = viewpoint(point);
    return VisibilityQuery(data_.visibility, from).visible_light();
  }

  bool is_outside(const Point& p) const {
    if (!options_.box) return false;
    const Box2& box = *options_.box;
    return p.x() < box.min.x || p.x() > box.max.x || p.y() < box.min.y || p.y() > box.max.y;
  }

  bool is_outside(std::uint32_t face) const { return outside_[face]; }

  void label_faces() {
    for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end(); ++face) {
      face->set_data(static_cast<std::uint32_t>(seen_.size()));
      const std::optional<Point> p = face->is_unbounded() ? std::nullopt : std::optional(inner_point(face));
      outside_.push_back(!p || is_outside(*p));
      seen_.push_back(outside_.back() ? VisibleLight{} : visible_from(*p));
    }
  }

  bool same_label(const VisibleLight& a, const VisibleLight& b) const {
    return a.region == b.region && (options_.fineness == Fineness::regions || same_names(a, b));
  }

  /// Off the blockers and the light's line f is continuous: between two faces that are both lit, or both dark, it can
  /// be nothing else.
  bool is_beyond_doubt(BoundaryKind kind, Region beside) const {
    if (data_.visibility.flatland().has_point_light()) return false;
    return kind != BoundaryKind::blocker && kind != BoundaryKind::light_line && beside != Region::penumbra;
  }

  BoundaryKind kind_of(Halfedge edge) const { return data_.names[edge->curve().data()].kind; }

  /// True if the edge's own points have the label of the face beside it.
  bool is_like(Halfedge edge, const VisibleLight& beside) const {
    const BoundaryKind kind = kind_of(edge);
    if (is_beyond_doubt(kind, beside.region)) return true;
    const VisibleLight seen = visible_from(inner_point(edge));
    const bool may_jump = kind == BoundaryKind::blocker || kind == BoundaryKind::light_line;
    return may_jump ? same_label(seen, beside) : seen.region == beside.region;
  }

  bool is_boundary(Halfedge edge) const {
    if (is_frame(edge)) return true;
    const std::uint32_t left = edge->face()->data(), right = edge->twin()->face()->data();
    if (is_outside(left) || is_outside(right)) return is_outside(left) != is_outside(right);
    return !same_label(seen_[left], seen_[right]) || !is_like(edge, seen_[left]);
  }

  /// Marks the halfedges that stay.
  void choose_edges() {
    for (auto edge = arrangement_.edges_begin(); edge != arrangement_.edges_end(); ++edge) {
      const bool stays = is_boundary(edge);
      edge->set_data(stays ? unnumbered : gone);
      edge->twin()->set_data(stays ? unnumbered : gone);
    }
  }

  /// True for what stands for infinity.
  bool is_frame(Halfedge edge) const { return edge->curve().data() == data_.names.size(); }

  static bool stays(Halfedge edge) { return edge->data() != gone; }

  void number_faces() {
    boost::disjoint_sets_with_storage<> groups(seen_.size());
    for (auto edge = arrangement_.edges_begin(); edge != arrangement_.edges_end(); ++edge) {
      if (stays(edge)) continue;
      const std::uint32_t left = edge->face()->data(), right = edge->twin()->face()->data();
      groups.union_set(left, right);
    }
    std::vector<std::uint32_t> number(seen_.size(), nowhere);
    face_of_.assign(seen_.size(), nowhere);
    for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end(); ++face) {
      const std::uint32_t own = face->data();
      if (is_outside(own)) continue;
      std::uint32_t& group = number[groups.find_set(own)];
      if (group == nowhere) {
        group = static_cast<std::uint32_t>(data_.faces.size());
        data_.faces.push_back({seen_[own].region, true, {}, {}, {}});
        if (options_.fineness == Fineness::structure) data_.faces.back().visible = seen_[own].intervals;
      }
      face_of_[own] = group;
    }
    for (auto edge = arrangement_.halfedges_begin(); edge != arrangement_.halfedges_end(); ++edge) {
      if (is_frame(edge) && left_face(edge) != nowhere) data_.faces[left_face(edge)].bounded = false;
    }
  }

  std::uint32_t left_face(Halfedge edge) const { return face_of_[edge->face()->data()]; }

  /// The halfedges that stay and leave a vertex.
  std::vector<Halfedge> leaving(Vertex vertex) const {
    std::vector<Halfedge> list;
    auto edge = vertex->incident_halfedges();
    const auto first = edge;
    do {
      if (stays(edge)) list.push_back(edge->twin());
    } while (++edge != first);
    return list;
  }

  /// Numbers the vertices of the partition; what an edge runs straight through is none, nor what no edge meets.
  void choose_vertices() {
    for (auto vertex = arrangement_.vertices_begin(); vertex != arrangement_.vertices_end(); ++vertex) {
      vertex->set_data(passed);
      const std::vector<Halfedge> edges = leaving(vertex);
      if (edges.empty()) continue;
      const bool is_straight = edges.size() == 2 && edges[0]->curve().data() == edges[1]->curve().data();
      if (std::ranges::any_of(edges, [&](Halfedge edge) { return is_frame(edge); })) {
        vertex->set_data(nowhere);
      } else if (!is_straight) {
        add_vertex(vertex);
      }
    }
  }

  void add_vertex(Vertex vertex) {
    vertex->set_data(static_cast<std::uint32_t>(data_.vertices.size()));
    const ExactPoint p = exact(vertex->point());
    data_.vertices.push_back({nearest_double(p.x), nearest_double(p.y)});
    data_.exact_vertices.push_back(p);
  }

  /// True if a partition's edge begins with this halfedge.
  static bool begins_edge(Halfedge edge) { return edge->source()->data() != passed; }

  void make_edges() {
    for (auto edge = arrangement_.halfedges_begin(); edge != arrangement_.halfedges_end(); ++edge) {
      if (edge->data() == unnumbered && begins_edge(edge) && !is_frame(edge)) make_edge(edge);
    }
  }

  void make_edge(Halfedge first) {
    const auto number = static_cast<std::uint32_t>(data_.edges.size());
    Halfedge last = first;
    const auto mark = [&] {
      last->set_data(2 * number);
      last->twin()->set_data(2 * number + 1);
    };
    mark();
    while (last->target()->data() == passed) {
      const std::vector<Halfedge> next = leaving(last->target());
      last = next[0] == last->twin() ? next[1] : next[0];
      mark();
    }
    data_.edges.push_back({first->source()->data(), last->target()->data(), left_face(first), left_face(first->twin()),
                           first->curve().data()});
    data_.edge_points.push_back({exact(first->source()->point()), exact(last->target()->point())});
  }

  static Halfedge next_staying(Halfedge edge) {
    Halfedge next = edge->next();
    while (!stays(next)) next = next->twin()->next();
    return next;
  }

  void make_cycles() {
    std::unordered_map<const void*, bool> done;
    for (auto edge = arrangement_.halfedges_begin(); edge != arrangement_.halfedges_end(); ++edge) {
      if (!stays(edge) || done[&*edge]) continue;
      std::vector<EdgeUse> cycle;
      Halfedge walker = edge;
      do {
        done[&*walker] = true;
        if (!is_frame(walker) && begins_edge(walker)) {
          const auto way = walker->data() % 2 == 0 ? EdgeUse::Way::forward : EdgeUse::Way::backward;
          cycle.push_back({walker->data() / 2, way});
        }
        walker = next_staying(walker);
      } while (walker != Halfedge(edge));
      if (left_face(edge) != nowhere) data_.faces[left_face(edge)].boundary.push_back(std::move(cycle));
    }
  }

  /// Single points inside a face that have another region.
  void make_points() {
    for (auto vertex = arrangement_.vertices_begin(); vertex != arrangement_.vertices_end(); ++vertex) {
      if (!leaving(vertex).empty()) continue;
      auto edge = vertex->incident_halfedges();
      const std::uint32_t face = edge->face()->data();
      if (is_outside(face) || is_like_all(vertex, seen_[face].region)) continue;
      if (visible_from(vertex->point()).region == seen_[face].region) continue;
      add_vertex(vertex);
      data_.faces[face_of_[face]].points.push_back(vertex->data());
    }
  }

  bool is_like_all(Vertex vertex, Region region) const {
    auto edge = vertex->incident_halfedges();
    const auto first = edge;
    do {
      if (!is_beyond_doubt(kind_of(edge), region)) return false;
    } while (++edge != first);
    return true;
  }

  static constexpr std::uint32_t gone = nowhere;
  static constexpr std::uint32_t unnumbered = nowhere - 1;
  static constexpr std::uint32_t passed = nowhere - 1;  ///< of a vertex that is none of the partition's

  PartitionOptions options_;
  Partition::Data data_;
  EventArrangement arrangement_;
  std::vector<VisibleLight> seen_;      ///< from every face
  std::vector<bool> outside_;           ///< of the box
  std::vector<std::uint32_t> face_of_;  ///< the partition's face of each face
};

}  // namespace

Partition partition(const LightVisibility& visibility, const PartitionOptions& options) {
  if (options.box && !has_interior(*options.box)) {
    throw PreconditionError("a box needs finite coordinates and an interior");
  }
  return Partition(std::make_shared<const Partition::Data>(Builder(visibility, options).result()));
}

}  // namespace gnomon::planar
