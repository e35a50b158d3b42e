#pragma once

/// @file
/// A scene and its shadows, ready to be written and drawn.
///
///     #include <gnomon/result.h>
///     int main() {
///       using namespace gnomon;
///       const Scene scene = parse_scene(default_scene_text(), "default", ".");
///       const auto& space = std::get<SpaceScene>(scene);
///       PairResult pair;
///       pair.volumes = shadow_volumes(space.lights.front().shape, scene_bodies(space).obstacles.blockers.front());
///       const ShadowResult result{&scene, default_clip_box(scene).value(), {pair}};
///       return result.pairs.front().volumes.occlusion_facts.empty ? 1 : 0;
///     }

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gnomon/flatland_partition.h"
#include "gnomon/flatland_regions.h"
#include "gnomon/irradiance.h"
#include "gnomon/pair.h"
#include "gnomon/point.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "gnomon/shadow_mesh.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

/// What one light and one convex blocker of a scene give.
struct PairResult {
  std::uint32_t light_id = 0;    ///< index into SpaceScene::lights
  std::uint32_t blocker_id = 0;  ///< index into SpaceScene::blockers
  std::string light;
  std::string blocker;  ///< a part of a larger blocker is named `vase#12`
  Position position = Position::standard;
  bool supported = false;  ///< false: `volumes` and `meshes` are not there
  bool is_solid = false;   ///< the blocker has an inside, and the umbra may have pockets outside of it
  ShadowVolumes volumes;
  ShadowMeshes meshes;
};

/// What one light and one segment of a scene of the plane give. Every position is supported.
struct PlanarPairResult {
  std::uint32_t light_id = 0;    ///< index into PlaneScene::lights
  std::uint32_t blocker_id = 0;  ///< index into PlaneScene::blockers
  std::string light;
  std::string blocker;  ///< part k of a polyline is named `fence#k`
  Position position = Position::standard;
  planar::ShadowRegions regions;
  planar::ShadowRegionsInBox in_box;
};

/// What one light of a scene of the plane gives behind all segments asked for together.
struct PlanarLightResult {
  std::uint32_t light_id = 0;  ///< index into PlaneScene::lights
  std::string light;
  std::vector<std::string> blockers;       ///< names of the segments, in the partition's order
  std::vector<std::uint32_t> blocker_ids;  ///< of the same: indices into PlaneScene::blockers
  planar::Partition partition;             ///< of the clip box
  planar::PartitionInBox in_box;
};

/// The occlusion volumes of one light and all parts of one blocker, or of all blockers, as one.
struct MergedResult {
  /// What all blockers together are called; no blocker can have this name.
  static constexpr std::string_view all_blockers = "all#blockers";

  std::uint32_t light_id = 0;    ///< index into SpaceScene::lights
  std::uint32_t blocker_id = 0;  ///< index into SpaceScene::blockers
  std::string light;
  std::string blocker;  ///< the whole one, or all_blockers
  MergedOcclusion occlusion;
  std::vector<std::string> part_names = {};  ///< of all parts, in their order
  /// Of each part, its blocker: index into SpaceScene::blockers. For all blockers together; else none.
  std::vector<std::uint32_t> part_blockers = {};
};

/// What one receiver, a flat piece of a receiver of the file, receives of one light behind all blockers together.
struct ReceiverResult {
  std::uint32_t light_id = 0;     ///< index into SpaceScene::lights
  std::uint32_t receiver_id = 0;  ///< index into SpaceScene::receivers
  std::string light;
  std::string receiver;
  ReceiverMesh mesh;
  std::vector<double> visible_fractions = {};  ///< of each vertex, if it was asked for
  std::string side = receiver;                 ///< the receiver, or its side, that the piece belongs to
  std::vector<Irradiance> irradiance = {};     ///< [W/m²] of each point of mesh.drawing(), if there is an eye
  std::vector<RadianceRgb> radiance = {};      ///< the same: reflected of this light to the eye
};

/// One side of a receiver in triangles that are fine enough to be painted by what they receive of one light.
struct PaintedReceiver {
  std::uint32_t light_id = 0;  ///< index into SpaceScene::lights
  std::string light;
  std::string side;  ///< the receiver, or its side
  std::vector<Point3> points;
  std::vector<Irradiance> irradiance;                     ///< [W/m²] of each point, as its own face has it
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< counterclockwise seen from the front
};

/// The pieces of one side of a receiver, one after the other, that receive of one light.
using SideResult = std::span<const ReceiverResult>;

/// The results, side by side in their order.
std::vector<SideResult> sides_of(std::span<const ReceiverResult> receivers);

/// The areas of a side's regions, summed up over its pieces.
std::array<RegionArea, receiver_region_count> areas_of(SideResult side);

/// A scene and its shadows, ready to be written and drawn.
struct ShadowResult {
  const Scene* scene = nullptr;  ///< never null when used; outlives the result
  Box3 clip_box;                 ///< the box by which the meshes are cut; in dimension 2, z runs from 0 to 0
  std::vector<PairResult> pairs;
  std::vector<PlanarPairResult> planar_pairs = {};  ///< dimension 2, where `pairs` is empty
  /// Dimension 2: the lights that are behind more than one segment.
  std::vector<PlanarLightResult> planar_lights = {};
  std::vector<MergedResult> merged = {};  ///< dimension 3: blockers of several parts, if asked for
  /// Dimension 3: receivers divided by what they receive of a light, where that is supported. Light by light.
  std::vector<ReceiverResult> receivers = {};
  /// Dimension 3: sides of receivers that are painted by irradiance in place of regions, if asked for.
  std::vector<PaintedReceiver> painted = {};
};

}  // namespace gnomon
