#include "geometry/discontinuity/receiver_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/discontinuity/plane_traces.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/discontinuity/receiver_sight.h"
#include "geometry/discontinuity/wedge.h"
#include "geometry/rounding.h"

namespace gnomon {
namespace {

using event::EventScene;
using event::FlatPoint;
using event::FlatSegment;
using event::ReceiverArrangement;
using event::ReceiverPlane;

/// Numbers events on one receiver, equal ones alike.
class NameTable {
 public:
  std::uint32_t number(const EventName& name) {
    const auto [found, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back(name);
    return found->second;
  }
  std::vector<EventName> take() { return std::move(names_); }

 private:
  std::map<EventName, std::uint32_t> numbers_;
  std::vector<EventName> names_;
};

/// All traces of wedges, by receiver.
struct AllTraces {
  std::vector<std::vector<event::Trace>> by_receiver;
  std::vector<EventName> names;
};

AllTraces all_traces(const EventScene& scene) {
  AllTraces all{std::vector<std::vector<event::Trace>>(scene.receivers.size()), {}};
  event::WedgeTracer tracer(scene);
  std::vector<event::Trace> traces;
  event::for_each_wedge(scene, [&](const event::Wedge& wedge) {
    traces.clear();
    tracer.append_traces(wedge, traces);
    if (traces.empty()) return;
    for (event::Trace& trace : traces) {
      trace.name = static_cast<std::uint32_t>(all.names.size());
      all.by_receiver[trace.receiver].push_back(std::move(trace));
    }
    all.names.push_back(event::event_name(scene, wedge));
  });
  return all;
}

std::vector<FlatPoint> flat_corners(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane) {
  std::vector<FlatPoint> corners;
  for (const event::PointId p : scene.receivers[receiver].corners) {
    corners.push_back(plane.flat(exact(scene.points[p].input)));
  }
  return corners;
}

/// Everything that divides a receiver, its border first.
std::vector<FlatSegment> dividing_segments(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                                           const AllTraces& traces, NameTable& names) {
  std::vector<FlatSegment> segments;
  const std::vector<FlatPoint> corners = flat_corners(scene, receiver, plane);
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    const EventElement element{EventOf::receiver, receiver, k};
    const std::uint32_t name = names.number({EventKind::border, element, element, 0, Extremal::none});
    segments.push_back({corners[k], corners[(k + 1) % corners.size()], name});
  }
  for (const event::Trace& trace : traces.by_receiver[receiver]) {
    const FlatSegment segment{plane.flat(trace.ends[0]), plane.flat(trace.ends[1]),
                              names.number(traces.names[trace.name])};
    if (!(segment.start == segment.end)) segments.push_back(segment);
  }
  std::vector<event::NamedSegment> others;
  event::append_plane_traces(scene, receiver, plane, others);
  for (event::NamedSegment& other : others) {
    if (!event::clip(other.segment, corners)) continue;
    other.segment.name = names.number(other.name);
    segments.push_back(other.segment);
  }
  return segments;
}

ReceiverPlane plane_of(const EventScene& scene, std::uint32_t receiver) {
  const auto& c = scene.receivers[receiver].corners;
  return {scene.points[c[0]].input, scene.points[c[1]].input, scene.points[c[2]].input};
}

std::vector<ExactVector> vertices_of(const ReceiverMesh::Data& data, const MeshFace& face) {
  std::vector<ExactVector> vertices;
  for (const MeshEdgeUse use : face.cycles[0]) {
    const MeshEdge& edge = data.edges[use / 2];
    vertices.push_back(data.plane.spatial(data.point(use % 2 == 0 ? edge.source : edge.target)));
  }
  return vertices;
}

void label_faces(ReceiverMesh::Data& data, event::ReceiverSight& sight) {
  for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
    const ExactVector inside = data.plane.spatial(data.arrangement.inner_point(f));
    const event::FaceRegion found = sight.region_of_face(inside, vertices_of(data, data.faces[f]));
    data.faces[f].region =
        found.is_certain ? static_cast<ReceiverRegion>(found.region) : ReceiverRegion::unresolved_eee;
  }
}

std::shared_ptr<ReceiverMesh::Data> subdivision(const EventScene& scene, std::uint32_t receiver,
                                                const AllTraces& traces) {
  NameTable names;
  const ReceiverPlane plane = plane_of(scene, receiver);
  const auto segments = dividing_segments(scene, receiver, plane, traces, names);
  auto data = std::make_shared<ReceiverMesh::Data>(
      ReceiverMesh::Data{plane, ReceiverArrangement(segments), {}, {}, names.take()});
  for (const ReceiverArrangement::Edge& e : data->arrangement.edges()) {
    data->edges.push_back({e.source, e.target, e.left, e.right, e.names});
  }
  for (const ReceiverArrangement::Face& f : data->arrangement.faces()) {
    data->faces.push_back({ReceiverRegion::lit, f.cycles});
  }
  return data;
}

}  // namespace

Rational doubled_flat_area(const ReceiverMesh::Data& data, std::span<const std::vector<MeshEdgeUse>> cycles) {
  Rational area = 0;
  for (const auto& cycle : cycles) {
    for (const MeshEdgeUse use : cycle) {
      const MeshEdge& edge = data.edges[use / 2];
      const FlatPoint p = data.point(edge.source), q = data.point(edge.target);
      const Rational part = p.x * q.y - p.y * q.x;
      if (use % 2 == 0) {
        area += part;
      } else {
        area -= part;
      }
    }
  }
  return area;
}

std::vector<ReceiverMesh> receiver_meshes(const Light& light, std::span<const ConvexBlocker> blockers,
                                          std::span<const ConvexPolygon> receivers) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const EventScene scene(light, blockers, receivers);
  const AllTraces traces = all_traces(scene);
  std::vector<ReceiverMesh> meshes;
  for (std::uint32_t r = 0; r < receivers.size(); ++r) {
    const CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    const auto data = subdivision(scene, r, traces);
    event::ReceiverSight sight(scene, light, blockers, r, data->plane);
    label_faces(*data, sight);
    meshes.emplace_back(data);
  }
  return meshes;
}

}  // namespace gnomon
