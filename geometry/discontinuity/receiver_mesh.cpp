#include "gnomon/receiver_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "geometry/bodies/body.h"
#include "geometry/discontinuity/face_labels.h"
#include "geometry/discontinuity/horizon_traces.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/plane_traces.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/discontinuity/receiver_visibility.h"
#include "geometry/discontinuity/wedge.h"
#include "geometry/parallel.h"
#include "gnomon/errors.h"

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

/// What the wedges of one source leave on receivers.
struct SourceTraces {
  std::vector<event::Trace> traces;
  std::vector<EventName> names;
};

/// Traces with a scene of its own, to which points are added while wedges are found.
class SourceTracer {
 public:
  explicit SourceTracer(const EventScene& scene) : scene_(scene), tracer_(scene_) {}
  SourceTracer(const SourceTracer&) = delete;

  SourceTraces traces(std::size_t source) {
    const CGAL::Protect_FPU_rounding<true> upward;
    SourceTraces found;
    event::for_each_wedge(scene_, source, [&](const event::Wedge& wedge) {
      const std::size_t before = found.traces.size();
      tracer_.append_traces(wedge, found.traces);
      if (found.traces.size() == before) return;
      for (std::size_t k = before; k < found.traces.size(); ++k) {
        found.traces[k].name = static_cast<std::uint32_t>(found.names.size());
      }
      found.names.push_back(event::event_name(scene_, wedge));
    });
    return found;
  }

 private:
  EventScene scene_;
  event::WedgeTracer tracer_;
};

/// The same for any number of threads: in the order of sources.
AllTraces all_traces(const EventScene& scene, unsigned threads) {
  std::vector<std::unique_ptr<SourceTracer>> tracers(std::max(1U, threads));
  std::vector<SourceTraces> found(event::wedge_source_count(scene));
  for_all(found.size(), threads, [&](std::size_t source, std::size_t worker) {
    if (!tracers[worker]) tracers[worker] = std::make_unique<SourceTracer>(scene);
    found[source] = tracers[worker]->traces(source);
  });
  AllTraces all{std::vector<std::vector<event::Trace>>(scene.receivers.size()), {}};
  for (SourceTraces& of_source : found) {
    for (event::Trace& trace : of_source.traces) {
      trace.name += static_cast<std::uint32_t>(all.names.size());
      all.by_receiver[trace.receiver].push_back(std::move(trace));
    }
    all.names.insert(all.names.end(), of_source.names.begin(), of_source.names.end());
  }
  return all;
}

std::vector<FlatPoint> flat_corners(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane) {
  std::vector<FlatPoint> corners;
  for (const event::PointId p : scene.receivers[receiver].corners) {
    corners.push_back(plane.flat(exact_place(scene.points[p])));
  }
  return corners;
}

/// Everything that divides a receiver, its border first.
std::vector<FlatSegment> dividing_segments(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                                           const event::LightBefore& light, const AllTraces& traces, NameTable& names,
                                           unsigned threads) {
  std::vector<FlatSegment> segments;
  const std::vector<FlatPoint> corners = flat_corners(scene, receiver, plane);
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    const EventElement element{EventOf::receiver, EventBody{receiver}, EventIndex{k}};
    const std::uint32_t name = names.number({EventKind::border, element, element, 0, Extremal::none});
    segments.push_back({corners[k], corners[(k + 1) % corners.size()], name});
  }
  if (light.is_empty()) return segments;
  const std::vector<event::Trace>& own = traces.by_receiver[receiver];
  std::vector<FlatSegment> flat(own.size());
  for_all(own.size(), threads, [&](std::size_t k, std::size_t) {
    flat[k] = {plane.flat(own[k].ends[0]), plane.flat(own[k].ends[1]), own[k].name};
  });
  for (FlatSegment& segment : flat) {
    segment.name = names.number(traces.names[segment.name]);
    if (!(segment.start == segment.end)) segments.push_back(std::move(segment));
  }
  std::vector<event::NamedSegment> others;
  event::append_plane_traces(scene, receiver, plane, others);
  event::append_horizon_traces(scene, receiver, plane, light, others);
  for (event::NamedSegment& other : others) {
    if (!event::clip(other.segment, corners)) continue;
    other.segment.name = names.number(other.name);
    segments.push_back(other.segment);
  }
  return segments;
}

ReceiverPlane plane_of(const EventScene& scene, std::uint32_t receiver) {
  const auto& c = scene.receivers[receiver].plane;
  return {scene.points[c[0]].input, scene.points[c[1]].input, scene.points[c[2]].input};
}

std::shared_ptr<ReceiverMesh::Data> subdivision(const EventScene& scene, std::uint32_t receiver,
                                                const ReceiverPlane& plane, const event::LightBefore& light,
                                                const AllTraces& traces, unsigned threads) {
  NameTable names;
  std::vector<FlatSegment> segments;
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    segments = dividing_segments(scene, receiver, plane, light, traces, names, threads);
  }
  auto data = std::make_shared<ReceiverMesh::Data>(
      ReceiverMesh::Data{plane, ReceiverArrangement(segments), {}, {}, names.take(), {}, {}});
  for (const ReceiverArrangement::Edge& e : data->arrangement.edges()) {
    data->edges.push_back({e.source, e.target, e.left, e.right, e.names});
  }
  for (const ReceiverArrangement::Face& f : data->arrangement.faces()) {
    data->faces.push_back({ReceiverRegion::lit, f.cycles});
  }
  return data;
}

}  // namespace

struct ReceiverDivision::Data {
  Light light;
  std::vector<ConvexBlocker> blockers;
  std::shared_ptr<const EventScene> scene;
  AllTraces traces;
  event::VertexShadows shadows;
  std::vector<ClosedSurface> enclosures;  ///< those that the light may touch: others hide it by their facets
};

namespace {

event::VertexShadows vertex_shadows(const EventScene& scene) {
  const CGAL::Protect_FPU_rounding<true> upward;
  return event::VertexShadows(scene);
}

void require_range(const Light& light, std::span<const ConvexBlocker> blockers,
                   std::span<const ConvexPolygon> receivers) {
  const auto require = [](std::string_view refusal) {
    if (!refusal.empty()) throw PreconditionError("a light, blocker or receiver " + std::string(refusal));
  };
  require(range_refusal(light));
  for (const ConvexBlocker& blocker : blockers) {
    require(std::visit([](const auto& shape) { return range_refusal(shape.points()); }, blocker));
  }
  for (const ConvexPolygon& receiver : receivers) require(range_refusal(receiver.points()));
}

/// Intervals are true only while results are rounded upwards.
EventScene prepared(const Light& light, std::span<const ConvexBlocker> blockers,
                    std::span<const ConvexPolygon> receivers) {
  require_range(light, blockers, receivers);
  const CGAL::Protect_FPU_rounding<true> upward;
  return {light, blockers, receivers};
}

event::LightBefore light_before_plane(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane) {
  const CGAL::Protect_FPU_rounding<true> upward;
  return event::light_before(scene, scene.receivers[receiver], plane);
}

/// Whether their boxes have a point in common.
bool may_touch(const Light& light, const ClosedSurface& surface) {
  if (std::holds_alternative<DirectionalLight>(light)) return false;
  const std::vector<Point3> points = light_points(light);
  for (double Point3::*c : {&Point3::x, &Point3::y, &Point3::z}) {
    const auto is_less = [&](const Point3& a, const Point3& b) { return a.*c < b.*c; };
    const auto [low, high] = std::ranges::minmax_element(points, is_less);
    const auto [first, last] = std::ranges::minmax_element(surface.vertices, is_less);
    if ((*high).*c < (*first).*c || (*last).*c < (*low).*c) return false;
  }
  return true;
}

}  // namespace

ReceiverDivision::ReceiverDivision(const Light& light, std::span<const ConvexBlocker> blockers,
                                   std::span<const ConvexPolygon> receivers, unsigned threads,
                                   std::span<const ClosedSurface> enclosures) {
  const auto scene = std::make_shared<const EventScene>(prepared(light, blockers, receivers));
  std::vector<ClosedSurface> touched;
  std::ranges::copy_if(enclosures, std::back_inserter(touched),
                       [&](const ClosedSurface& surface) { return may_touch(light, surface); });
  data_ = std::make_shared<const Data>(Data{light,
                                            {blockers.begin(), blockers.end()},
                                            scene,
                                            all_traces(*scene, threads),
                                            vertex_shadows(*scene),
                                            std::move(touched)});
}

std::size_t ReceiverDivision::size() const {
  return data_->scene->receivers.size();
}

ReceiverMesh ReceiverDivision::mesh(std::uint32_t receiver, unsigned threads) const {
  const ReceiverPlane plane = plane_of(*data_->scene, receiver);
  const event::LightBefore light = light_before_plane(*data_->scene, receiver, plane);
  const auto made = subdivision(*data_->scene, receiver, plane, light, data_->traces, threads);
  event::label_faces({*data_->scene, data_->shadows, data_->light, data_->blockers, receiver, light, data_->enclosures},
                     *made, threads);
  return ReceiverMesh(made);
}

namespace {

/// Whether some face at a vertex is no umbra: umbrae hold their boundaries.
std::vector<bool> vertices_off_umbra(const ReceiverMesh& mesh) {
  std::vector<bool> sees(mesh.vertex_count());
  for (const MeshEdge& edge : mesh.edges()) {
    for (const std::uint32_t f : {edge.left, edge.right}) {
      if (f == MeshEdge::nowhere || mesh.faces()[f].region == ReceiverRegion::umbra) continue;
      sees[edge.source] = sees[edge.target] = true;
    }
  }
  return sees;
}

}  // namespace

std::vector<double> ReceiverDivision::visible_fractions(std::uint32_t receiver, const ReceiverMesh& mesh,
                                                        unsigned threads) const {
  const ReceiverPlane& plane = mesh.data().plane;
  const event::ReceiverVisibility visibility(*data_->scene, data_->light, data_->blockers, receiver, plane);
  std::vector<event::ReceiverVisibility> visibilities(std::max(1U, threads), visibility);
  std::vector<double> fractions(mesh.vertex_count());
  const std::vector<bool> sees = vertices_off_umbra(mesh);
  for_all(fractions.size(), threads, [&](std::size_t v, std::size_t worker) {
    // An arc ends on the boundary of an umbra, which belongs to it.
    if (v >= mesh.data().arrangement.vertex_count() || !sees[v]) return;
    const ExactVector p = plane.spatial(mesh.data().point(static_cast<std::uint32_t>(v)));
    fractions[v] = visibilities[worker].visible_fraction_from(p).nearest;
  });
  return fractions;
}

std::vector<ReceiverMesh> receiver_division(const Light& light, std::span<const ConvexBlocker> blockers,
                                            std::span<const ConvexPolygon> receivers,
                                            std::span<const ClosedSurface> enclosures) {
  const ReceiverDivision division(light, blockers, receivers, 1, enclosures);
  std::vector<ReceiverMesh> meshes;
  for (std::uint32_t r = 0; r < receivers.size(); ++r) meshes.push_back(division.mesh(r));
  return meshes;
}

}  // namespace gnomon
