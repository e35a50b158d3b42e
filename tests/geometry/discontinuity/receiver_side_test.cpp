#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/discontinuity/receiver_mesh_data.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"
#include "tests/geometry/discontinuity/mesh_cases.h"
#include "tests/geometry/discontinuity/mesh_probe.h"
#include "tests/geometry/discontinuity/side_cases.h"
#include "tests/geometry/discontinuity/side_oracle.h"

namespace gnomon {
namespace {

using test_support::Dice;
using test_support::SideCase;

Rational doubled_turn(const event::FlatPoint& a, const event::FlatPoint& b, const event::FlatPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Rational coarse(const Rational& x) {
  using Integer = boost::multiprecision::mpz_int;
  const Integer scaled = numerator(Rational(x * 4096)) / denominator(Rational(x * 4096));
  return Rational(scaled, 4096);
}

/// A point inside a triangle of a mesh, of few digits where there is one.
event::FlatPoint point_inside(Dice& dice, const ReceiverMesh& mesh, const ReceiverTriangle& triangle) {
  std::array<event::FlatPoint, 3> c;
  Rational sum = 0, x = 0, y = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = mesh.data().point(triangle.vertices[k]);
    const Rational weight = dice.draw(1, 9);
    sum += weight;
    x += weight * c[k].x;
    y += weight * c[k].y;
  }
  const event::FlatPoint p{x / sum, y / sum}, q{coarse(p.x), coarse(p.y)};
  const auto is_left = [&](std::size_t k) { return doubled_turn(c[k], c[(k + 1) % 3], q) > 0; };
  return is_left(0) && is_left(1) && is_left(2) ? q : p;
}

/// Any triangle, but one that is lit or unlit once more only where the first was.
const ReceiverTriangle& some_triangle(Dice& dice, const ReceiverMesh& mesh,
                                      const std::vector<ReceiverTriangle>& triangles) {
  const ReceiverTriangle &first = dice.one_of(triangles), &second = dice.one_of(triangles);
  const ReceiverRegion region = mesh.faces()[first.face].region;
  return region == ReceiverRegion::lit || region == ReceiverRegion::unlit ? second : first;
}

/// What was met in many cases.
struct SideTally {
  std::array<std::size_t, receiver_region_count> points{};
  std::size_t meshes = 0;
  std::size_t with_horizon = 0;  ///< meshes with a trace of a line of sight in the receiver's plane
  std::size_t wrong = 0;
  std::size_t asked = 0;  ///< points that are doubles, of which `regions` is asked too

  std::size_t compared() const {
    std::size_t sum = 0;
    for (const std::size_t n : points) sum += n;
    return sum;
  }
};

bool is_right(ReceiverRegion label, Region region) {
  if (label == ReceiverRegion::unresolved_eee) return region == Region::penumbra || region == Region::umbra;
  return static_cast<int>(label) == static_cast<int>(region);
}

/// What `gnomon regions` tells of the point with the receiver's normal, where the point is one of doubles.
std::optional<Region> region_with_normal(const SideCase& drawn, const ConvexPolygon& receiver, const ExactVector& p) {
  const Point3 q{p.x.convert_to<double>(), p.y.convert_to<double>(), p.z.convert_to<double>()};
  if (!(exact(q) == p)) return std::nullopt;
  return exact_received(drawn.light, {drawn.blockers, {}}, {q, facet_front(receiver)}).region;
}

/// Compares points of some triangles of a receiver's mesh.
void compare(Dice& dice, const SideCase& drawn, std::uint32_t r, const ReceiverMesh& mesh, SideTally& tally) {
  EXPECT_TRUE(mesh.areas_add_up());
  ++tally.meshes;
  tally.with_horizon += std::any_of(mesh.names().begin(), mesh.names().end(),
                                    [](const EventName& name) { return name.kind == EventKind::horizon; });
  const auto triangles = straight_triangles(mesh);
  if (triangles.empty()) return;
  for (int n = 0; n < 5; ++n) {
    const ReceiverTriangle& triangle = some_triangle(dice, mesh, triangles);
    const event::ReceiverPlane& plane = mesh.data().plane;
    const ExactVector p = plane.spatial(point_inside(dice, mesh, triangle));
    const ReceiverRegion label = mesh.faces()[triangle.face].region;
    const Region region = test_support::region_before_plane(drawn.light, drawn.blockers, plane.plane().normal, p);
    ++tally.points[static_cast<std::size_t>(label)];
    const std::optional<Region> told = region_with_normal(drawn, drawn.receivers[r], p);
    tally.asked += told.has_value();
    if (is_right(label, region) && told.value_or(region) == region) continue;
    if (++tally.wrong > 5) continue;
    ADD_FAILURE() << "receiver r" << r << " at " << p.x << ", " << p.y << ", " << p.z << ": " << name(label)
                  << ", by definition " << static_cast<int>(region) << ", told with its normal "
                  << static_cast<int>(told.value_or(region)) << "\n"
                  << test_support::scene_text(drawn);
  }
}

template <class Draw>
SideTally compare_all(unsigned count, const Draw& draw) {
  SideTally tally;
  for (unsigned seed = 1; seed <= count; ++seed) {
    Dice dice(seed);
    const SideCase drawn = draw(dice);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ReceiverDivision division(drawn.light, drawn.blockers, drawn.receivers);
    for (std::uint32_t r = 0; r < division.size(); ++r) compare(dice, drawn, r, division.mesh(r), tally);
  }
  std::cout << count << " cases from seed 1: " << tally.meshes << " receivers, " << tally.with_horizon
            << " with a line of sight in their plane; points";
  for (std::size_t k = 0; k < tally.points.size(); ++k) {
    std::cout << " " << name(static_cast<ReceiverRegion>(k)) << " " << tally.points[k];
  }
  std::cout << "; wrong " << tally.wrong << "\n";
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_GT(3 * tally.asked, tally.compared());
  for (const ReceiverRegion region : {ReceiverRegion::lit, ReceiverRegion::penumbra, ReceiverRegion::umbra}) {
    EXPECT_GT(25 * tally.points[static_cast<std::size_t>(region)], tally.compared()) << name(region);
  }
  return tally;
}

constexpr unsigned case_count = GNOMON_LONG ? 20000 : 2000;

TEST(ReceiverSideAgreement, LabelsOfRoomsAreThoseOfTheDefinition) {
  const SideTally tally = compare_all(case_count, test_support::room);
  EXPECT_GT(8 * tally.with_horizon, tally.meshes);
}

TEST(ReceiverSideAgreement, LabelsOfTanglesAreThoseOfTheDefinition) {
  const SideTally tally = compare_all(case_count, test_support::tangle);
  EXPECT_GT(8 * tally.with_horizon, tally.meshes);
}

TEST(ReceiverSideAgreement, LabelsBehindWhatTouchesTheLightAreThoseOfTheDefinition) {
  compare_all(case_count, test_support::luminaire);
}

TEST(ReceiverSideAgreement, LabelsBehindMeshesAreThoseOfTheDefinition) {
  compare_all(case_count / 10, test_support::mesh_under_lamp);
}

/// Scenes that were once labelled wrong, each with points and areas worked out from the definition.
class AttackedScene : public ::testing::TestWithParam<std::string> {};

const std::string attacks = GNOMON_TEST_DATA "/scenes/attacks/";

std::vector<std::string> attack_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(attacks)) {
    const std::string name = entry.path().filename().string(), ending = ".scene.json";
    if (name.ends_with(ending)) names.push_back(name.substr(0, name.size() - ending.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string area_of(const ReceiverMesh& mesh, const std::string& region) {
  for (std::size_t k = 0; k < receiver_region_count; ++k) {
    if (name(static_cast<ReceiverRegion>(k)) == region) return mesh.areas()[k].exact.value_or("irrational");
  }
  return "unknown region";
}

TEST_P(AttackedScene, HasTheRegionsOfTheDefinition) {
  const auto scene = std::get<SpaceScene>(read_scene(attacks + GetParam() + ".scene.json"));
  const auto blockers = parts_of_blockers(scene);
  const Light& light = scene.lights.front().shape;
  const ReceiverMesh mesh = receiver_division(light, blockers, receivers_of(scene)).front();
  const auto expected = nlohmann::json::parse(std::ifstream(attacks + GetParam() + ".expected.json"));
  EXPECT_TRUE(mesh.areas_add_up());
  for (const auto& [region, area] : expected.at("areas").at("r0").items()) EXPECT_EQ(area_of(mesh, region), area);
  for (const auto& row : expected.at("points").at("r0")) {
    const ExactVector p = exact(Point3{row[0], row[1], row[2]});
    const auto face = face_at(mesh, p);
    ASSERT_TRUE(face) << row;
    EXPECT_EQ(name(mesh.faces()[*face].region), row[3]) << row;
    const Region region = test_support::region_before_plane(light, blockers, mesh.data().plane.plane().normal, p);
    EXPECT_EQ(name(static_cast<ReceiverRegion>(region)), row[3]) << row;
  }
}

INSTANTIATE_TEST_SUITE_P(ReceiverSide, AttackedScene, ::testing::ValuesIn(attack_names()),
                         [](const auto& attack) { return attack.param; });

using Blockers = std::vector<ConvexBlocker>;

ReceiverMesh mesh_before(const Light& light, const Blockers& blockers, const ConvexPolygon& receiver) {
  return receiver_division(light, blockers, std::vector{receiver}).front();
}

const Light lamp_above = lamp(rectangle(-1, -1, 1, 1, 2, Facing::down));
const ConvexPolygon upright = ConvexPolygon::from_points({{0, -4, 0}, {0, 4, 0}, {0, 4, 1}, {0, -4, 1}});

TEST(ReceiverSide, CountsOnlyWhatLiesBeforeTheReceiversPlane) {
  const ReceiverMesh open = mesh_before(lamp_above, {}, upright);
  EXPECT_EQ(area_of(open, "lit"), "8");
  const ReceiverDivision division(lamp_above, {}, std::vector{upright});
  for (const double fraction : division.visible_fractions(0, open)) EXPECT_EQ(fraction, 0.5);
  // A board over the half behind the wall hides nothing that counts, one over the half before it all of that.
  EXPECT_EQ(area_of(mesh_before(lamp_above, {rectangle(-9, -9, 0, 9, 1.5, Facing::up)}, upright), "lit"), "8");
  EXPECT_EQ(area_of(mesh_before(lamp_above, {rectangle(0, -9, 9, 9, 1.5, Facing::up)}, upright), "umbra"), "8");
}

TEST(ReceiverSide, OfABlockersFacetIsTheLimitFromItsFront) {
  const ConvexBlocker block = box({-1, -1, 0}, {1, 1, 1});
  EXPECT_EQ(area_of(mesh_before(lamp_above, {block}, rectangle(-1, -1, 1, 1, 1, Facing::up)), "lit"), "4");
  EXPECT_EQ(area_of(mesh_before(lamp_above, {block}, rectangle(-1, -1, 1, 1, 1, Facing::down)), "unlit"), "4");
  EXPECT_EQ(area_of(mesh_before(lamp_above, {block}, rectangle(-1, -1, 1, 1, 0, Facing::up)), "umbra"), "4");
  EXPECT_EQ(area_of(mesh_before(lamp_above, {block}, rectangle(-1, -1, 1, 1, 0, Facing::down)), "unlit"), "4");
}

TEST(ReceiverSide, NeverHasABlockerInItsPlaneHideAnything) {
  const ConvexPolygon plate = rectangle(-1, -1, 1, 1, 0, Facing::down);
  EXPECT_EQ(area_of(mesh_before(lamp_above, {plate}, rectangle(-3, -3, 3, 3, 0, Facing::up)), "lit"), "36");
  EXPECT_EQ(area_of(mesh_before(lamp_above, {plate}, plate), "unlit"), "4");
}

TEST(ReceiverSideDegenerate, OfALightInThePlaneOrBehindIsUnlit) {
  const ConvexPolygon floor = rectangle(-3, -3, 3, 3, 0, Facing::up);
  const auto is_unlit = [&](const Light& light) { return area_of(mesh_before(light, {}, floor), "unlit") == "36"; };
  EXPECT_TRUE(is_unlit(PointLight{{1, 1, 0}}));
  EXPECT_TRUE(is_unlit(DirectionalLight{{1, 0, 0}}));
  EXPECT_TRUE(is_unlit(DirectionalLight{{1, 0, 1}}));
  EXPECT_TRUE(is_unlit(LinearLight{{1, 1, 0}, {2, 1, -1}}));
  EXPECT_TRUE(is_unlit(AreaLight{rectangle(4, 0, 5, 1, 0, Facing::up), true}));
  EXPECT_TRUE(is_unlit(AreaLight{ConvexPolygon::from_points({{4, 0, 0}, {4, 1, 0}, {4, 0, -1}}), true}));
  EXPECT_FALSE(is_unlit(LinearLight{{1, 1, 0}, {2, 1, 1}}));
}

TEST(ReceiverSideDegenerate, AGapBetweenTwoFeetClosesWhereTheyAreInLine) {
  // The sides of the gap lean towards each other, so that it is open at the floor only; they are not coplanar.
  const Light window = lamp(ConvexPolygon::from_points({{-4, -1, 0}, {-4, 1, 0}, {-4, 1, 1}, {-4, -1, 1}}));
  const Blockers walls{ConvexPolygon::from_points({{0, -9, 0}, {0, 0, 0}, {0, 2, 4}, {0, -9, 4}}),
                       ConvexPolygon::from_points({{1, 9, 0}, {1, 0, 0}, {1, -2, 4}, {1, 9, 4}})};
  const ReceiverMesh mesh = mesh_before(window, walls, rectangle(2, -0.25, 4, 0.25, 0, Facing::up));
  EXPECT_EQ(area_of(mesh, "umbra"), "1/2");
  EXPECT_EQ(area_of(mesh, "penumbra"), "1/2");
  const bool is_traced = std::any_of(mesh.names().begin(), mesh.names().end(), [](const EventName& n) {
    return n.kind == EventKind::horizon && n.vertex.of == EventOf::blocker && n.edge.of == EventOf::blocker;
  });
  EXPECT_TRUE(is_traced);
}

}  // namespace
}  // namespace gnomon
