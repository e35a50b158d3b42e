#include "gnomon/illumination.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/bodies/body.h"
#include "geometry/parallel.h"
#include "geometry/shared_work.h"
#include "gnomon/errors.h"
#include "gnomon/receiver_mesh.h"
#include "shading/illumination/brightest_place.h"
#include "shading/illumination/coplanar_receivers.h"
#include "shading/illumination/group_meshes.h"
#include "shading/illumination/outlines.h"
#include "shading/illumination/packed_meshes.h"
#include "shading/illumination/refinement.h"
#include "shading/illumination/touching_places.h"

namespace gnomon {
namespace {

using illumination::extent_of;
using illumination::LightsTogether;
using illumination::Outline;
using illumination::Probe;
using illumination::ReceiverTraces;
using illumination::Refinement;
using illumination::RefinementGoal;
using illumination::Trace;
using illumination::TriangleState;

/// What is known of each receiver before it is meshed.
struct ReceiverFacts {
  ReceiverTraces traces;
  std::vector<ExactVector> touching;
  std::vector<Probe> probes;
  std::optional<Probe> brightest;
};

void append(ReceiverTraces& all, ReceiverTraces more) {
  all.traces.insert(all.traces.end(), more.traces.begin(), more.traces.end());
  all.inside.insert(all.inside.end(), more.inside.begin(), more.inside.end());
}

class Illuminating {
 public:
  Illuminating(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
               std::span<const ConvexPolygon> receivers, const IlluminationEffort& effort)
      : sources_(lights),
        obstacles_(obstacles),
        receivers_(receivers),
        effort_(effort),
        lights_(lights, obstacles, receivers, effort.unit, effort.threads),
        groups_(illumination::coplanar_groups(receivers)),
        facts_(receivers.size()) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (effort.processes.is_mine(g)) own_.insert(own_.end(), groups_[g].begin(), groups_[g].end());
    }
    std::ranges::sort(own_);
  }

  Illumination made() {
    require_same_points(effort_.processes, all_points());
    result_.meshes.resize(receivers_.size());
    for (IlluminationMesh& mesh : result_.meshes) mesh.order = effort_.order;
    share_largest([&] {
      divide();
      ask_probes();
    });
    share_largest([&] { seek_brightest(); });
    result_.tolerance = effort_.is_relative ? effort_.tolerance * result_.largest : effort_.tolerance;
    share_meshes();
    return std::move(result_);
  }

 private:
  std::vector<Point3> all_points() const {
    std::vector<Point3> all;
    const auto add = [&](const auto& shape) { all.insert(all.end(), shape.points().begin(), shape.points().end()); };
    for (const ConvexPolygon& receiver : receivers_) add(receiver);
    for (const ConvexBlocker& blocker : obstacles_.blockers) std::visit(add, blocker);
    for (const IlluminationLight& light : sources_) {
      for (const Light& part : light.parts) {
        const std::vector<Point3> points = light_points(part);
        all.insert(all.end(), points.begin(), points.end());
      }
    }
    return all;
  }

  /// Does this process's work, and lets all know the largest irradiance that any has found.
  void share_largest(const std::function<void()>& work) {
    std::vector<std::vector<double>> largest(effort_.processes.count);
    share_results<double>(effort_.processes, largest, [&] {
      work();
      largest[effort_.processes.number] = {result_.largest};
    });
    for (const std::vector<double>& one : largest) result_.largest = std::max(result_.largest, one.front());
  }

  /// Makes the meshes of this process's groups, and gets those of the others.
  void share_meshes() {
    std::vector<std::vector<char>> packed(groups_.size());
    std::vector<std::vector<std::size_t>> evaluations(effort_.processes.count);
    share_results<char>(effort_.processes, packed, [&] {
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        if (!effort_.processes.is_mine(g)) continue;
        mesh_group(groups_[g]);
        done_ += groups_[g].size();
        tell_faces(0);
        if (effort_.processes.count > 1) packed[g] = illumination::packed(result_.meshes, groups_[g]);
      }
    });
    share_results<std::size_t>(effort_.processes, evaluations,
                               [&] { evaluations[effort_.processes.number] = {lights_.evaluations()}; });
    for (const std::vector<std::size_t>& one : evaluations) result_.evaluations += one.front();
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!effort_.processes.is_mine(g)) illumination::unpack(packed[g], groups_[g], result_.meshes);
    }
  }

  void divide() {
    std::vector<Light> parts;
    for (const IlluminationLight& light : sources_) parts.insert(parts.end(), light.parts.begin(), light.parts.end());
    const std::vector<Body> bodies = illumination::touching_bodies(parts, obstacles_.blockers);
    std::vector<ConvexPolygon> own;
    for (const std::uint32_t r : own_) own.push_back(receivers_[r]);
    for_all(own_.size(), effort_.threads, [&](std::size_t i, std::size_t) {
      facts_[own_[i]].touching = illumination::touching_places(bodies, own[i]);
    });
    for (const Light& part : parts) {
      const ReceiverDivision division(part, obstacles_.blockers, own, effort_.threads, obstacles_.enclosures);
      for_all(own_.size(), effort_.threads, [&](std::size_t i, std::size_t) {
        append(facts_[own_[i]].traces, illumination::traces_of(division.mesh(static_cast<std::uint32_t>(i))));
      });
    }
  }

  void ask_probes() {
    std::vector<Probe*> all;
    for (const std::uint32_t r : own_) {
      for (const Point3& p : facts_[r].traces.inside) facts_[r].probes.push_back({r, p, {}});
      for (Probe& probe : facts_[r].probes) all.push_back(&probe);
    }
    for_all(all.size(), effort_.threads, [&](std::size_t i, std::size_t worker) {
      all[i]->irradiance = lights_.sum(worker, all[i]->receiver, all[i]->point);
    });
    for (const Probe* probe : all) tell_largest(probe->irradiance);
  }

  void seek_brightest() {
    for_all(own_.size(), effort_.threads, [&](std::size_t i, std::size_t worker) {
      const std::uint32_t r = own_[i];
      const auto brightest = std::ranges::max_element(facts_[r].probes, {}, value_of);
      if (brightest == facts_[r].probes.end() || result_.largest == 0) return;
      if (value_of(*brightest) < result_.largest / 4) return;
      facts_[r].brightest = illumination::brightest_place(receivers_[r], *brightest, lights_, worker);
    });
    for (const ReceiverFacts& facts : facts_) {
      if (facts.brightest) tell_largest(facts.brightest->irradiance);
    }
  }

  static double value_of(const Probe& probe) {
    return std::isfinite(probe.irradiance.value) ? probe.irradiance.value : 0;
  }

  void tell_largest(const Irradiance& found) {
    if (std::isfinite(found.value)) result_.largest = std::max(result_.largest, found.value);
  }

  void mesh_group(std::span<const std::uint32_t> group) {
    std::vector<const ConvexPolygon*> members;
    std::vector<ReceiverTraces> traces;
    std::size_t regions = 0;
    for (const std::uint32_t r : group) {
      members.push_back(&receivers_[r]);
      regions += facts_[r].traces.inside.size();
      traces.push_back(std::move(facts_[r].traces));
    }
    const auto refined = [&](bool has_all_traces, std::size_t most) {
      return refined_between(group, illumination::outline_of(members, traces, has_all_traces ? 2 : 1), has_all_traces,
                             most);
    };
    const std::size_t most = group.size() * effort_.most_faces;
    const bool has_choice = effort_.split == IlluminationSplit::need && has_second_order(traces);
    if (!has_choice) return write(group, refined(effort_.split == IlluminationSplit::all, most));
    // The one that is likely cheaper first; the other stops once it is not better.
    const bool all_first = regions <= few_regions;
    Refinement first = refined(all_first, most);
    if (!all_first && regions >= first.states().size()) return write(group, first);
    Refinement second = refined(!all_first, std::min(most, first.states().size()));
    const auto cost = [](const Refinement& one) {
      return std::pair(std::ranges::count(one.states(), false, &TriangleState::is_met), one.states().size());
    };
    write(group, cost(second) < cost(first) ? second : first);
  }

  static constexpr std::size_t few_regions = 2000;

  static bool has_second_order(std::span<const ReceiverTraces> traces) {
    return std::ranges::any_of(traces, [](const ReceiverTraces& of_receiver) {
      return std::ranges::any_of(of_receiver.traces, [](const Trace& trace) { return trace.order >= 2; });
    });
  }

  Refinement refined_between(std::span<const std::uint32_t> group, Outline outline, bool has_all_traces,
                             std::size_t most) {
    std::vector<Probe> probes;
    std::vector<Point3> many_limits;
    for (const std::uint32_t r : group) {
      const ReceiverFacts& facts = facts_[r];
      probes.insert(probes.end(), facts.probes.begin(), facts.probes.end());
      for (const ExactVector& p : facts.touching) {
        outline.corners.push_back(p);
        many_limits.push_back(illumination::nearest_point(p));
      }
      if (facts.brightest) add_brightest(outline, facts.brightest->point, extent_of(receivers_[r].points()));
    }
    std::vector<Point3> all;
    for (const auto& ring : outline.rings) {
      for (const ExactVector& p : ring) all.push_back(illumination::near_point(p));
    }
    const bool tries_edges = has_all_traces && effort_.order == 1;
    const RefinementGoal goal{result_.tolerance,
                              effort_.order,
                              tries_edges,
                              most,
                              0x1p-40 * extent_of(all),
                              effort_.threads,
                              [&](std::size_t triangles) { tell_faces(triangles); }};
    Refinement refined(illumination::first_triangles(outline), group, many_limits, std::move(probes), lights_, goal);
    refined.run();
    return refined;
  }

  /// Faces beside those that are written.
  void tell_faces(std::size_t more) const {
    if (effort_.progress) effort_.progress(done_, receivers_.size(), faces_ + more);
  }

  /// The brightest place becomes a corner, unless it is so near to a line that thin triangles would come of it.
  static void add_brightest(Outline& outline, const Point3& p, double extent) {
    const auto is_near = [&](const ExactVector& a, const ExactVector& b) {
      return illumination::distance(p, illumination::near_point(a), illumination::near_point(b)) < 0x1p-8 * extent;
    };
    for (const auto& ring : outline.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (is_near(ring[k], ring[(k + 1) % ring.size()])) return;
      }
    }
    if (std::ranges::none_of(outline.traces, [&](const Trace& t) { return is_near(t.a, t.b); })) {
      outline.corners.push_back(exact(p));
    }
  }

  void write(std::span<const std::uint32_t> group, const Refinement& refined) {
    faces_ += refined.states().size();
    illumination::write_meshes(refined, lights_, effort_.threads, group, result_.meshes);
  }

  std::span<const IlluminationLight> sources_;
  const Obstacles& obstacles_;
  std::span<const ConvexPolygon> receivers_;
  const IlluminationEffort& effort_;
  LightsTogether lights_;
  std::vector<std::vector<std::uint32_t>> groups_;  ///< of receivers that are meshed together
  std::vector<std::uint32_t> own_;                  ///< the receivers of this process, ascending
  std::vector<ReceiverFacts> facts_;
  std::size_t done_ = 0;   ///< receivers
  std::size_t faces_ = 0;  ///< of them
  Illumination result_;
};

}  // namespace

Illumination illuminate(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
                        std::span<const ConvexPolygon> receivers, const IlluminationEffort& effort) {
  if (!(effort.tolerance > 0)) throw PreconditionError("a tolerance is larger than 0");
  if (effort.order != 1 && effort.order != 2) throw PreconditionError("faces are of order 1 or 2");
  return Illuminating(lights, obstacles, receivers, effort).made();
}

}  // namespace gnomon
