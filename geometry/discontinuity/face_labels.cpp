#include "geometry/discontinuity/face_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/bodies/closed_surface.h"
#include "geometry/discontinuity/arc_faces.h"
#include "geometry/discontinuity/quick_visibility.h"
#include "geometry/discontinuity/receiver_visibility.h"
#include "geometry/discontinuity/shaft.h"
#include "geometry/parallel.h"

namespace gnomon::event {
namespace {

std::uint32_t start_of(const ReceiverMesh::Data& data, MeshEdgeUse use) {
  return use % 2 == 0 ? data.edges[use / 2].source : data.edges[use / 2].target;
}

std::vector<ExactVector> vertices_of(const ReceiverMesh::Data& data, const MeshFace& face) {
  std::vector<ExactVector> vertices;
  for (const MeshEdgeUse use : face.cycles[0]) {
    vertices.push_back(data.plane.spatial(data.point(start_of(data, use))));
  }
  return vertices;
}

bool is_enclosed(const ExactVector& point, std::span<const ClosedSurface> enclosures) {
  return std::any_of(enclosures.begin(), enclosures.end(),
                     [&](const ClosedSurface& surface) { return encloses(surface, point); });
}

/// What a face was found to be: of one region, or divided.
struct AskedFace {
  ReceiverRegion region = ReceiverRegion::lit;
  std::optional<FaceDivision> division;
};

/// Asks about faces, one at a time.
class FaceAsker {
 public:
  FaceAsker(const LitReceiver& lit, const ReceiverMesh::Data& data)
      : lit_(lit),
        data_(data),
        quick_(lit.scene, lit.shadows, lit.receiver, lit.before),
        visibility_(lit.scene, lit.light, lit.blockers, lit.receiver, data.plane) {}

  /// What intervals tell of a face.
  std::optional<QuickAnswer> quick_answer(std::uint32_t f) {
    const FlatEnclosure flat = inner_point(f);
    const CGAL::Protect_FPU_rounding<true> upward;
    const PointEnclosure p = data_.plane.spatial(flat);
    Point3 middle{p[0].inf() / 2 + p[0].sup() / 2, p[1].inf() / 2 + p[1].sup() / 2, p[2].inf() / 2 + p[2].sup() / 2};
    const double size = std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)});
    for (const Interval& c : {p.x, p.y, p.z}) {
      if (!(c.sup() - c.inf() <= 0x1p-44 * size)) return std::nullopt;
    }
    find_boxes(lit_.scene.shape_boxes, shaft(lit_.scene, {&middle, 1}), near_);
    const std::optional<QuickAnswer> answer = quick_.region(p, near_);
    const auto is_covered = [&] { return answer->cover && hides_light_from(f, *answer->cover) == true; };
    if (!answer || !(answer->is_certain_of_face || is_covered())) return std::nullopt;
    return answer;
  }

  /// The region of a face, exactly, or its cells where arcs divide it.
  AskedFace asked_face(std::uint32_t f) {
    const ExactVector inside = data_.plane.spatial(data_.arrangement.inner_point(f));
    const std::vector<ExactVector> vertices = vertices_of(data_, data_.faces[f]);
    const FaceRegion found =
        visibility_.region_of_face({inside, vertices, [&](ShapeId s) { return hides_light_from(f, s); }});
    if (found.is_certain) return {static_cast<ReceiverRegion>(found.region), std::nullopt};
    const ClosingArcs arcs =
        closing_arcs(lit_.scene, visibility_.blockers_near(vertices), face_pieces(data_, data_.faces[f]), data_.plane);
    if (arcs.arcs.empty()) return {static_cast<ReceiverRegion>(found.region), std::nullopt};
    return divided_face(f, arcs);
  }

 private:
  AskedFace divided_face(std::uint32_t f, const ClosingArcs& arcs) {
    FaceSides sides = sides_of(data_, data_.faces[f]);
    const conic::CurveMap map(sides.sides, arcs.arcs);
    if (!map.is_complete()) return {ReceiverRegion::unresolved_eee, std::nullopt};
    FaceCells cells = face_cells(map, sides.sides, [&](const FlatPoint& p) {
      return static_cast<ReceiverRegion>(visibility_.region_of(data_.plane.spatial(p)));
    });
    const ReceiverRegion first = cells.cells.front().region;
    if (!cells.is_divided()) return {first, std::nullopt};
    const std::uint8_t order = lit_.scene.kind == LightKind::linear ? 1 : 2;
    FaceDivision division{f, std::move(cells), std::move(sides.vertices), {}};
    for (const auto& [a, b, c] : arcs.names) {
      division.names.push_back({EventKind::triple_edge, a, b, order, Extremal::umbra, c});
    }
    return {first, std::move(division)};
  }

  /// A narrow box around the point by which a face is judged.
  FlatEnclosure inner_point(std::uint32_t f) const {
    const FlatEnclosure near = data_.arrangement.near_inner_point(f);
    const auto is_narrow = [](const Interval& c) {
      return c.sup() - c.inf() <= 0x1p-46 * std::max(std::fabs(c.inf()), std::fabs(c.sup()));
    };
    if (is_narrow(near.x) && is_narrow(near.y)) return near;
    const FlatPoint point = data_.arrangement.inner_point(f);
    const auto x = CGAL::to_interval(point.x), y = CGAL::to_interval(point.y);
    return {Interval(x.first, x.second), Interval(y.first, y.second)};
  }

  /// Whether one blocker hides all of the light from every vertex of the face, so from all of its hull; nothing where
  /// that is not known of some vertex of the light, or does not matter of one in or behind the receiver's plane.
  std::optional<bool> hides_light_from(std::uint32_t f, ShapeId shape) const {
    const CGAL::Protect_FPU_rounding<true> upward;
    const auto n = static_cast<std::uint32_t>(lit_.scene.light_vertices.size());
    for (std::uint32_t l = 0; l < n; ++l) {
      if (!lit_.shadows.knows(l, shape)) return std::nullopt;
    }
    for (const MeshEdgeUse use : data_.faces[f].cycles[0]) {
      const std::uint32_t v = start_of(data_, use);
      const PointEnclosure near = data_.plane.spatial(data_.arrangement.near_point(v));
      for (std::uint32_t l = 0; l < n; ++l) {
        if (lit_.shadows.holds(l, shape, near, [&] { return data_.plane.spatial(data_.point(v)); })) continue;
        return lit_.before.is_whole() ? std::optional(false) : std::nullopt;
      }
    }
    return true;
  }

  const LitReceiver& lit_;
  const ReceiverMesh::Data& data_;
  QuickVisibility quick_;
  ReceiverVisibility visibility_;
  std::vector<std::uint32_t> near_;
};

/// Finds the regions of faces, by intervals where these tell, and spreads them across edges that do not change them.
class FaceLabels {
 public:
  FaceLabels(const LitReceiver& lit, ReceiverMesh::Data& data, unsigned threads)
      : lit_(lit), data_(data), is_labelled_(data.faces.size()) {
    for (unsigned k = 0; k < std::max(1U, threads); ++k) askers_.push_back(std::make_unique<FaceAsker>(lit, data));
  }

  void label_all() {
    const auto n = static_cast<std::uint32_t>(data_.faces.size());
    for (std::uint32_t f = 0; f < n; ++f) {
      if (lit_.before.is_empty()) set(f, ReceiverRegion::unlit);
    }
    if (lit_.before.is_empty()) return;
    for (std::uint32_t f = 0; f < n && !lit_.enclosures.empty(); ++f) {
      const ExactVector inside = data_.plane.spatial(data_.arrangement.inner_point(f));
      if (is_enclosed(inside, lit_.enclosures)) set(f, ReceiverRegion::umbra);
    }
    for (std::uint32_t first = 0; first < n;) first = label_quickly(first);
    ask_exactly();
  }

 private:
  /// Labels some faces from `first` on by intervals. Answers are taken in the order of faces, and each as if those
  /// before had been taken, so that it does not matter how many are found at once. Returns: the first face after them.
  std::uint32_t label_quickly(std::uint32_t first) {
    const std::size_t most = askers_.size() > 1 ? 256 : 1;
    std::vector<std::uint32_t> faces;
    for (; first < data_.faces.size() && faces.size() < most; ++first) {
      if (!is_labelled_[first]) faces.push_back(first);
    }
    std::vector<std::optional<QuickAnswer>> answers(faces.size());
    ask(faces.size(), [&](FaceAsker& asker, std::size_t i) { answers[i] = asker.quick_answer(faces[i]); });
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (is_labelled_[faces[i]] || !answers[i]) continue;
      set(faces[i], static_cast<ReceiverRegion>(answers[i]->region));
      if (lit_.before.is_whole()) spread(faces[i], *answers[i]);
    }
    return first;
  }

  template <class Question>
  void ask(std::size_t n, const Question& question) {
    for_all(n, static_cast<unsigned>(askers_.size()),
            [&](std::size_t i, std::size_t worker) { question(*askers_[worker], i); });
  }

  void ask_exactly() {
    std::vector<std::uint32_t> left;
    for (std::uint32_t f = 0; f < data_.faces.size(); ++f) {
      if (!is_labelled_[f]) left.push_back(f);
    }
    std::vector<AskedFace> asked(left.size());
    ask(left.size(), [&](FaceAsker& asker, std::size_t i) { asked[i] = asker.asked_face(left[i]); });
    std::vector<FaceDivision> divisions;
    for (std::size_t i = 0; i < left.size(); ++i) {
      set(left[i], asked[i].region);
      if (asked[i].division) divisions.push_back(std::move(*asked[i].division));
    }
    divide_faces(divisions, data_);
  }

  void set(std::uint32_t f, ReceiverRegion region) {
    data_.faces[f].region = region;
    is_labelled_[f] = true;
  }

  /// Carries an answer as far as no edge may change what it rests on.
  void spread(std::uint32_t first, const QuickAnswer& answer) {
    const auto is_kept = [&](const MeshEdge& edge) {
      return std::all_of(edge.names.begin(), edge.names.end(), [&](std::uint32_t n) {
        return answer.region == Region::lit ? keeps_light_whole(data_.names[n])
                                            : answer.witness && keeps(data_.names[n], *answer.witness);
      });
    };
    std::vector<std::uint32_t> waiting{first};
    while (!waiting.empty()) {
      const std::uint32_t f = waiting.back();
      waiting.pop_back();
      for (const auto& cycle : data_.faces[f].cycles) {
        for (const MeshEdgeUse use : cycle) {
          const MeshEdge& edge = data_.edges[use / 2];
          const std::uint32_t other = use % 2 == 0 ? edge.right : edge.left;
          if (other == MeshEdge::nowhere || is_labelled_[other] || !is_kept(edge)) continue;
          set(other, data_.faces[first].region);
          waiting.push_back(other);
        }
      }
    }
  }

  /// False if some light may begin or end to be hidden there: that happens along boundaries of occlusion alone.
  static bool keeps_light_whole(const EventName& name) {
    return name.kind == EventKind::vertex_edge && name.extremal == Extremal::none;
  }

  /// False if a light vertex of two may appear or vanish there: along edges in line with it, and nowhere else.
  bool keeps(const EventName& name, const std::array<std::uint32_t, 2>& light_vertices) const {
    if (name.kind != EventKind::vertex_edge) return false;
    return std::none_of(light_vertices.begin(), light_vertices.end(), [&](std::uint32_t l) {
      const LightVertex& v = lit_.scene.light_vertices[l];
      const auto ends_at_v = [&](const LightEdge& e) {
        return e.name == name.edge && (e.a == v.point || e.b == v.point);
      };
      return name.vertex == v.name ||
             std::any_of(lit_.scene.light_edges.begin(), lit_.scene.light_edges.end(), ends_at_v);
    });
  }

  const LitReceiver& lit_;
  ReceiverMesh::Data& data_;
  std::vector<std::unique_ptr<FaceAsker>> askers_;  ///< of each thread
  std::vector<bool> is_labelled_;
};

}  // namespace

void label_faces(const LitReceiver& lit, ReceiverMesh::Data& data, unsigned threads) {
  FaceLabels(lit, data, threads).label_all();
}

}  // namespace gnomon::event
