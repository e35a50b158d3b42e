#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gnomon/discontinuity.h"
#include "gnomon/flatland_pair.h"
#include "gnomon/flatland_partition.h"
#include "gnomon/flatland_regions.h"
#include "gnomon/light_design.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/reflection.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {

/// A receiver's mesh as plain lists, as ReceiverMesh has them.
struct DividedReceiver {
  std::vector<Point3> vertices;  ///< rounded to nearest; after the mesh's own those of triangles inside of arcs
  std::vector<MeshEdge> edges;
  std::vector<ReceiverRegion> faces;  ///< their regions
  std::vector<EventName> names;
  std::vector<ReceiverTriangle> triangles;
  std::vector<MeshArc> arcs;
};

/// A receiver, divided by what it receives of a light.
DividedReceiver divided_receiver(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                 const ConvexPolygon& receiver);

/// For each point the blockers that a search finds as perhaps hiding a linear light; nothing where it is not asked.
using FoundOccluders = std::vector<std::optional<std::vector<std::uint32_t>>>;

FoundOccluders found_occluders(const LinearLight& light, const std::vector<ConvexBlocker>& blockers,
                               const LinearSearch& search, const std::vector<Point3>& points);

/// What points see of a linear light with such a search, those of receivers with the normal.
std::vector<Visibility> searched_visibility(const LinearLight& light, const std::vector<ConvexBlocker>& blockers,
                                            const LinearSearch& search, const std::vector<Point3>& points,
                                            const Point3& normal);

/// What a shadow tree tells of points; nothing where it leaves them open. No tree for lights with a size.
std::vector<std::optional<Region>> tree_regions(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                                const std::vector<Point3>& points);

/// Whether a value of a design's variable is feasible, by cells about it; nothing on boundaries and where they are
/// flat.
std::optional<bool> design_place(const Design& design, const DesignObstacles& obstacles, const Point3& position);

/// The functions the laws are about, as values: a test may pass a broken one to see that a law catches it.
struct Subject {
  // A lambda: private headers know another overload.
  std::function<ExtremalPlanes(const Light&, const ConvexPolygon&)> extremal_planes =
      [](const Light& light, const ConvexPolygon& blocker) { return gnomon::extremal_planes(light, blocker); };
  std::function<ShadowVolumes(const Light&, const ConvexBlocker&)> shadow_volumes = gnomon::shadow_volumes;
  std::function<ConvexVolume(const Light&, const ConvexBlocker&)> convex_hull_shadow_volume =
      gnomon::convex_hull_shadow_volume;
  std::function<std::array<planar::ExtremalLine, 4>(const planar::Pair&)> planar_extremal_lines =
      planar::extremal_lines;
  std::function<planar::ShadowRegions(const planar::Pair&)> planar_regions = planar::shadow_regions;
  std::function<Visibility(const Light&, const Obstacles&, const Point3&)> visibility = gnomon::exact_visibility;
  std::function<Region(const planar::Pair&, const Point2&)> planar_region_of = planar::region_of;
  std::function<planar::VisibleLight(const planar::Flatland&, const Point2&)> planar_visible_light =
      [](const planar::Flatland& flatland, const Point2& p) {
        return planar::LightVisibility(flatland).visible_light(p);
      };
  std::function<planar::Partition(const planar::Flatland&)> planar_partition = [](const planar::Flatland& flatland) {
    return planar::partition(planar::LightVisibility(flatland));
  };
  std::function<std::vector<DiscontinuitySurface>(const Light&, const std::vector<ConvexBlocker>&,
                                                  const std::vector<ConvexPolygon>&, const Box3&)>
      discontinuity_surfaces = [](const auto& light, const auto& blockers, const auto& receivers, const Box3& box) {
        return gnomon::discontinuity_surfaces(light, blockers, receivers, box);
      };
  std::function<DividedReceiver(const Light&, const std::vector<ConvexBlocker>&, const ConvexPolygon&)>
      divided_receiver = laws::divided_receiver;
  std::function<Reflection(const Light&, const Obstacles&, const gnomon::View&, ReflectionModel, int exponent)>
      reflection =
          [](const Light& light, const Obstacles& obstacles, const gnomon::View& view, ReflectionModel model,
             int exponent) { return LightReflection(light, PreparedObstacles(obstacles)).at(view, model, exponent); };
  std::function<FoundOccluders(const LinearLight&, const std::vector<ConvexBlocker>&, const LinearSearch&,
                               const std::vector<Point3>&)>
      found_occluders = laws::found_occluders;
  std::function<std::vector<Visibility>(const LinearLight&, const std::vector<ConvexBlocker>&, const LinearSearch&,
                                        const std::vector<Point3>&, const Point3& normal)>
      searched_visibility = laws::searched_visibility;
  std::function<std::vector<std::optional<Region>>(const Light&, const std::vector<ConvexBlocker>&,
                                                   const std::vector<Point3>&)>
      tree_regions = laws::tree_regions;
  std::function<std::optional<bool>(const Design&, const DesignObstacles&, const Point3&)> design_place =
      laws::design_place;
  std::function<DesignResult(const Design&, const DesignObstacles&, const DesignEffort&)> solved_design =
      gnomon::solved_design;
};

}  // namespace gnomon::laws
