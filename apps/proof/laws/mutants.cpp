#include "apps/proof/laws/mutants.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "apps/proof/laws/law_lists.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/planar/partition_data.h"

namespace gnomon::laws {
namespace {

using planar::ExtremalLine;
using planar::ShadowRegions;
using Keys = std::vector<std::string>;
using Lines = std::array<ExtremalLine, 4>;

/// The words of a mutant.
struct Words {
  std::string name;
  std::string does;
};

Mutant planes(const Words& words, Keys caught_by, void (*break_them)(ExtremalPlanes&)) {
  Mutant mutant{words.name, words.does, Part::extremal_planes, {}, std::move(caught_by)};
  mutant.subject.extremal_planes = [=, original = mutant.subject.extremal_planes](const auto& light,
                                                                                  const auto& blocker) {
    ExtremalPlanes found = original(light, blocker);
    break_them(found);
    return found;
  };
  return mutant;
}

Mutant volumes(const Words& words, Keys caught_by, void (*break_them)(ShadowVolumes&)) {
  Mutant mutant{words.name, words.does, Part::shadow_volumes, {}, std::move(caught_by)};
  mutant.subject.shadow_volumes = [=, original = mutant.subject.shadow_volumes](const auto& light,
                                                                                const auto& blocker) {
    ShadowVolumes found = original(light, blocker);
    break_them(found);
    return found;
  };
  return mutant;
}

Mutant visibility(const Words& words, Keys caught_by,
                  Visibility (*broken)(const Light&, const Obstacles&, const Point3&)) {
  Mutant mutant{words.name, words.does, Part::visibility, {}, std::move(caught_by)};
  mutant.subject.visibility = broken;
  return mutant;
}

Mutant lines(const Words& words, Keys caught_by, void (*break_them)(Lines&)) {
  Mutant mutant{words.name, words.does, Part::planar_extremal_lines, {}, std::move(caught_by)};
  mutant.subject.planar_extremal_lines = [=](const planar::Pair& pair) {
    Lines found = planar::extremal_lines(pair);
    break_them(found);
    return found;
  };
  return mutant;
}

Mutant regions(const Words& words, Keys caught_by, void (*break_them)(ShadowRegions&)) {
  Mutant mutant{words.name, words.does, Part::planar_regions, {}, std::move(caught_by)};
  mutant.subject.planar_regions = [=](const planar::Pair& pair) {
    ShadowRegions found = planar::shadow_regions(pair);
    break_them(found);
    return found;
  };
  return mutant;
}

Mutant planar_visibility(const Words& words, Keys caught_by,
                         planar::VisibleLight (*broken)(const planar::Flatland&, const Point2&)) {
  Mutant mutant{words.name, words.does, Part::planar_visible_light, {}, std::move(caught_by)};
  mutant.subject.planar_visible_light = broken;
  return mutant;
}

void drop_kind(ConvexVolume& volume, FacetKind kind) {
  std::erase_if(volume.half_spaces, [=](const HalfSpace& half_space) { return half_space.name.kind == kind; });
}

void drop_last(ConvexVolume& volume) {
  if (!volume.half_spaces.empty()) volume.half_spaces.pop_back();
}

void turn_last(ConvexVolume& volume) {
  if (volume.half_spaces.empty()) return;
  auto& plane = volume.half_spaces.back().plane;
  std::swap(plane[0], plane[1]);
}

/// Moves every plane inward by so little that only points on it notice.
void make_strict(ConvexVolume& volume) {
  for (HalfSpace& half_space : volume.half_spaces) {
    auto& [a, b, c] = half_space.plane;
    const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    for (Point3* p : {&a, &b, &c}) *p = {p->x - 0x1p-40 * n.x, p->y - 0x1p-40 * n.y, p->z - 0x1p-40 * n.z};
  }
}

template <class Vertex>
Vertex neighbour(Vertex vertex) {
  return Vertex{number(vertex) == 0 ? 1U : number(vertex) - 1};
}

std::vector<Mutant> plane_mutants() {
  return {
      planes({"swap_planes", "separating and supporting blocker planes exchanged"}, {"S2", "S7", "S10"},
             [](ExtremalPlanes& p) { std::swap(p.separating_blocker, p.supporting_blocker); }),
      planes({"neighbour_separating", "the light's neighbouring vertex in a separating plane"}, {"S2", "S10"},
             [](ExtremalPlanes& p) {
               p.separating_blocker.front().vertex = neighbour(p.separating_blocker.front().vertex);
             }),
      planes({"neighbour_supporting", "the light's neighbouring vertex in a supporting plane"}, {"S7", "S10"},
             [](ExtremalPlanes& p) {
               p.supporting_blocker.front().vertex = neighbour(p.supporting_blocker.front().vertex);
             }),
      planes({"neighbour_light_plane", "the blocker's neighbouring vertex in a separating light plane"}, {"S3", "S10"},
             [](ExtremalPlanes& p) {
               if (p.separating_light.empty()) return;
               p.separating_light.front().vertex = neighbour(p.separating_light.front().vertex);
             }),
      planes({"drop_supporting", "a supporting plane forgotten"}, {"S10"},
             [](ExtremalPlanes& p) { p.supporting_blocker.pop_back(); }),
      planes({"drop_light_plane", "a separating light plane forgotten"}, {"S10"},
             [](ExtremalPlanes& p) {
               if (!p.separating_light.empty()) p.separating_light.pop_back();
             }),
      planes({"double_separating", "a separating blocker plane listed twice"}, {"S10"},
             [](ExtremalPlanes& p) { p.separating_blocker.push_back(p.separating_blocker.back()); }),
  };
}

std::vector<Mutant> volume_mutants() {
  const Keys occlusion{"S4", "S5", "S6"}, umbra{"S8", "S9"};
  return {
      volumes({"swap_umbra", "the occlusion volume given as the umbra"}, umbra,
              [](ShadowVolumes& v) { v.umbra = v.occlusion; }),
      volumes({"swap_occlusion", "the umbra given as the occlusion volume"}, occlusion,
              [](ShadowVolumes& v) { v.occlusion = v.umbra; }),
      volumes({"drop_occlusion_half_space", "a half-space missing from the occlusion volume"},
              {"S1", "S4", "S5", "S6", "S6_any"}, [](ShadowVolumes& v) { drop_last(v.occlusion); }),
      volumes({"drop_light_half_spaces", "the light planes missing from the occlusion volume"}, occlusion,
              [](ShadowVolumes& v) { drop_kind(v.occlusion, FacetKind::separating_light_plane); }),
      volumes({"drop_umbra_half_space", "a half-space missing from the umbra"}, {"S1", "S8", "S9", "S9_any"},
              [](ShadowVolumes& v) { drop_last(v.umbra); }),
      volumes({"drop_blocker_face", "the blocker's plane missing from both volumes"},
              {"S1", "S4", "S5", "S6", "S8", "S9"},
              [](ShadowVolumes& v) {
                drop_kind(v.occlusion, FacetKind::blocker_face);
                drop_kind(v.umbra, FacetKind::blocker_face);
              }),
      volumes({"invert_occlusion", "a half-space of the occlusion volume turned round"}, {"S1", "S4", "S5", "S6"},
              [](ShadowVolumes& v) { turn_last(v.occlusion); }),
      volumes({"invert_umbra", "a half-space of the umbra turned round"}, {"S1", "S8", "S9"},
              [](ShadowVolumes& v) { turn_last(v.umbra); }),
      volumes({"strict_occlusion", "the boundary of the occlusion volume left out"}, {"S1", "S5", "S6"},
              [](ShadowVolumes& v) { make_strict(v.occlusion); }),
      volumes({"strict_umbra", "the boundary of the umbra left out"}, {"S1", "S8", "S9"},
              [](ShadowVolumes& v) { make_strict(v.umbra); }),
      volumes({"rounded_planes", "planes rounded"}, {"S1", "S4", "S5", "S6", "S8", "S9"},
              [](ShadowVolumes& v) {
                for (ConvexVolume* volume : {&v.occlusion, &v.umbra}) {
                  for (HalfSpace& half_space : volume->half_spaces) half_space.plane[2].z *= 1 + 0x1p-50;
                }
              }),
      volumes({"bounded_umbra", "every umbra said to be bounded"}, {"S12", "S12_any"},
              [](ShadowVolumes& v) { v.umbra_facts.bounded = true; }),
      volumes({"unbounded_umbra", "every umbra said to be unbounded"}, {"S12", "S12_any"},
              [](ShadowVolumes& v) { v.umbra_facts.bounded = false; }),
      volumes({"bounded_penumbra", "every penumbra said to be bounded"}, {"S13"},
              [](ShadowVolumes& v) { v.penumbra_facts.bounded = true; }),
      volumes({"penumbra_of_points", "no penumbra said to be empty"}, {"S13"},
              [](ShadowVolumes& v) { v.penumbra_facts.empty = false; }),
      volumes({"one_penumbra", "every penumbra said to be one"}, {"S14", "S14_any"},
              [](ShadowVolumes& v) { v.penumbra_facts.components = 1; }),
      volumes({"no_shared_umbra", "no umbra said to be there"}, {"S12", "F1"},
              [](ShadowVolumes& v) { v.umbra_facts = {}; }),
      volumes({"drop_umbra", "every umbra forgotten"}, {"S11"}, [](ShadowVolumes& v) { v.umbra.empty = true; }),
      volumes({"umbra_made_up", "no umbra forgotten, though none be there"}, {"S11"},
              [](ShadowVolumes& v) { v.umbra.empty = false; }),
      volumes({"one_pocket", "every umbra said to have one pocket"}, {"S15"},
              [](ShadowVolumes& v) { v.umbra_pockets = 1; }),
  };
}

Mutant hulls(const Words& words, Keys caught_by, ConvexVolume (*broken)(const Light&, const ConvexBlocker&)) {
  Mutant mutant{words.name, words.does, Part::convex_hull_shadow_volume, {}, std::move(caught_by)};
  mutant.subject.convex_hull_shadow_volume = broken;
  return mutant;
}

std::vector<Mutant> hull_mutants() {
  return {
      hulls({"drop_hull_half_space", "a half-space missing from the occlusion volume of a part"}, {"M4"},
            [](const Light& light, const ConvexBlocker& blocker) {
              ConvexVolume volume = convex_hull_shadow_volume(light, blocker);
              drop_last(volume);
              return volume;
            }),
      hulls({"skip_solids", "parts that are solids forgotten"}, {"M4"},
            [](const Light& light, const ConvexBlocker& blocker) {
              return std::holds_alternative<ConvexSolid>(blocker) ? ConvexVolume{{}, true}
                                                                  : convex_hull_shadow_volume(light, blocker);
            }),
  };
}

Visibility changed(const Light& light, const Obstacles& obstacles, const Point3& p, Region from, Region to) {
  Visibility seen = exact_visibility(light, obstacles, p);
  if (seen.region == from) seen.region = to;
  return seen;
}

std::vector<Mutant> visibility_mutants() {
  return {
      visibility({"skip_blocker", "the last blocker forgotten"}, {"M1", "M3", "E4", "F7"},
                 [](const Light& light, const Obstacles& obstacles, const Point3& p) {
                   Obstacles fewer = obstacles;
                   fewer.blockers.pop_back();
                   return exact_visibility(light, fewer, p);
                 }),
      visibility({"umbra_for_penumbra", "penumbra called umbra"}, {"M3", "F1"},
                 [](const Light& light, const Obstacles& obstacles, const Point3& p) {
                   return changed(light, obstacles, p, Region::penumbra, Region::umbra);
                 }),
      visibility({"penumbra_for_umbra", "umbra called penumbra"}, {"M2", "M3", "F1", "F6", "F7"},
                 [](const Light& light, const Obstacles& obstacles, const Point3& p) {
                   return changed(light, obstacles, p, Region::umbra, Region::penumbra);
                 }),
      visibility({"penumbra_for_light", "lit points called penumbra"}, {"M1", "M2", "F2"},
                 [](const Light& light, const Obstacles& obstacles, const Point3& p) {
                   return changed(light, obstacles, p, Region::lit, Region::penumbra);
                 }),
  };
}

void turn_last_side(planar::PlanarRegion& region) {
  if (region.empty() || region.pieces.back().sides.empty()) return;
  auto& side = region.pieces.back().sides.back();
  std::swap(side.from, side.to);
}

/// The region of a point, where umbra without its boundary counts.
Region strict_region_of(const planar::Pair& pair, const Point2& p) {
  const Region region = planar::region_of(pair, p);
  if (region != Region::umbra) return region;
  for (const Point2& l : pair.light()) {
    for (const Point2& b : pair.blocker()) {
      if (l != b && side_of(exact(l), exact(b), exact(p)) == 0) return Region::penumbra;
    }
  }
  return region;
}

std::vector<Mutant> planar_pair_mutants() {
  Mutant region_of{"strict_planar_umbra",
                   "the boundary of the umbra called penumbra",
                   Part::planar_region_of,
                   {},
                   {"P1", "P8", "P9"}};
  region_of.subject.planar_region_of = strict_region_of;
  return {
      lines({"swap_lines", "separating and supporting lines exchanged"}, {"P1", "P2", "P3", "P4", "P7", "P9"},
            [](Lines& all) {
              for (ExtremalLine& line : all) {
                line.contact = line.contact == Contact::separating ? Contact::supporting : Contact::separating;
              }
            }),
      lines({"neighbour_separating_line", "a separating line through the blocker's other end"}, {"P1", "P2"},
            [](Lines& all) { all[0].blocker_end = all[1].blocker_end; }),
      lines({"neighbour_supporting_line", "a supporting line through the blocker's other end"}, {"P4", "P7"},
            [](Lines& all) { all[2].blocker_end = all[3].blocker_end; }),
      regions({"drop_umbra_side", "an umbra without its last side"}, {"P4", "P7", "P8"},
              [](ShadowRegions& r) {
                if (!r.umbra.empty()) r.umbra.pieces.front().sides.pop_back();
              }),
      regions({"drop_penumbra_piece", "a penumbra without its last piece"}, {"P3", "P8"},
              [](ShadowRegions& r) {
                if (!r.penumbra.empty()) r.penumbra.pieces.pop_back();
              }),
      regions({"invert_penumbra_side", "a side of the penumbra turned round"}, {"P3", "P8"},
              [](ShadowRegions& r) { turn_last_side(r.penumbra); }),
      regions({"invert_lit_side", "a side of the lit region turned round"}, {"P2", "P8", "P10"},
              [](ShadowRegions& r) { turn_last_side(r.lit); }),
      regions({"one_umbra_more", "an umbra too many counted"}, {"P5", "P7", "P8", "P9", "P10"},
              [](ShadowRegions& r) { r.umbra.components += 1; }),
      regions({"one_penumbra_more", "a penumbra too many counted"}, {"P6", "P7", "P8", "P9", "P10"},
              [](ShadowRegions& r) { r.penumbra.components += 1; }),
      region_of,
  };
}

std::vector<Mutant> flatland_mutants() {
  Mutant renamed{
      "neighbour_event_point", "lines of events through another blocker's end", Part::planar_partition, {}, {"Q5"}};
  renamed.subject.planar_partition = [](const planar::Flatland& flatland) {
    auto data = planar::partition(planar::LightVisibility(flatland)).data();
    for (planar::BoundaryName& name : data.names) name.far = {planar::EventPointKind::blocker_end, 0, 0};
    return planar::Partition(std::make_shared<const planar::Partition::Data>(std::move(data)));
  };
  return {
      planar_visibility({"skip_segment", "the last segment forgotten"}, {"Q1", "Q2", "Q3", "Q4", "Q6", "F3", "F5"},
                        [](const planar::Flatland& flatland, const Point2& p) {
                          const auto& all = flatland.blockers();
                          const auto some =
                              planar::Flatland::from_points(flatland.light(), std::span(all).first(all.size() - 1));
                          return planar::LightVisibility(some).visible_light(p);
                        }),
      planar_visibility({"joined_penumbrae", "penumbra called umbra"}, {"Q2", "Q3", "F3", "F4"},
                        [](const planar::Flatland& flatland, const Point2& p) {
                          planar::VisibleLight seen = planar::LightVisibility(flatland).visible_light(p);
                          if (seen.region == Region::penumbra) seen.region = Region::umbra;
                          return seen;
                        }),
      renamed,
  };
}

}  // namespace

std::vector<Mutant> all_mutants() {
  std::vector<Mutant> all;
  for (auto& family : {planar_pair_mutants(), flatland_mutants(), plane_mutants(), volume_mutants(), hull_mutants(),
                       visibility_mutants(), event_mutants(), reflection_mutants(), search_mutants(), tree_mutants(),
                       design_mutants()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

Subject with_part_watched(Part part, std::function<void()> asked) {
  const auto watched = [&](auto function) {
    return [function, asked](const auto&... arguments) {
      asked();
      return function(arguments...);
    };
  };
  Subject subject;
  switch (part) {
    case Part::extremal_planes:
      subject.extremal_planes = watched(subject.extremal_planes);
      break;
    case Part::shadow_volumes:
      subject.shadow_volumes = watched(subject.shadow_volumes);
      break;
    case Part::convex_hull_shadow_volume:
      subject.convex_hull_shadow_volume = watched(subject.convex_hull_shadow_volume);
      break;
    case Part::visibility:
      subject.visibility = watched(subject.visibility);
      break;
    case Part::discontinuity_surfaces:
      subject.discontinuity_surfaces = watched(subject.discontinuity_surfaces);
      break;
    case Part::divided_receiver:
      subject.divided_receiver = watched(subject.divided_receiver);
      break;
    case Part::reflection:
      subject.reflection = watched(subject.reflection);
      break;
    case Part::found_occluders:
      subject.found_occluders = watched(subject.found_occluders);
      break;
    case Part::searched_visibility:
      subject.searched_visibility = watched(subject.searched_visibility);
      break;
    case Part::tree_regions:
      subject.tree_regions = watched(subject.tree_regions);
      break;
    case Part::design_place:
      subject.design_place = watched(subject.design_place);
      break;
    case Part::solved_design:
      subject.solved_design = watched(subject.solved_design);
      break;
    case Part::planar_extremal_lines:
      subject.planar_extremal_lines = watched(subject.planar_extremal_lines);
      break;
    case Part::planar_regions:
      subject.planar_regions = watched(subject.planar_regions);
      break;
    case Part::planar_region_of:
      subject.planar_region_of = watched(subject.planar_region_of);
      break;
    case Part::planar_visible_light:
      subject.planar_visible_light = watched(subject.planar_visible_light);
      break;
    case Part::planar_partition:
      subject.planar_partition = watched(subject.planar_partition);
      break;
  }
  return subject;
}

}  // namespace gnomon::laws
