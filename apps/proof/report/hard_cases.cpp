#include "apps/proof/report/hard_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "apps/proof/report/shapes.h"
#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

using Corpus = std::vector<HardCase>;

constexpr double infinity = std::numeric_limits<double>::infinity();

double up(double x) {
  return std::nextafter(x, infinity);
}

double down(double x) {
  return std::nextafter(x, -infinity);
}

const AreaLight lamp = square_light(1, 4);

ConvexBlocker triangle(const Point3& a, const Point3& b, const Point3& c) {
  return ConvexPolygon::from_points({a, b, c});
}

/// The square on its tip with the corner on the x axis moved.
ConvexBlocker diamond_with_tip(double x) {
  return ConvexPolygon::from_points({{x, 0, 2}, {0, 2, 2}, {-2, 0, 2}, {0, -2, 2}});
}

/// The case as it is, and with the tip of its blocker one ulp farther out and in.
void add_tip_case(Corpus& all, const std::string& name, const std::string& about, const Point3& focus) {
  all.push_back({name + "_exact", about, lamp, {diamond_with_tip(2)}, focus});
  all.push_back(
      {name + "_one_ulp_out", about + ", the blocker one ulp larger", lamp, {diamond_with_tip(up(2))}, focus});
  all.push_back(
      {name + "_one_ulp_in", about + ", the blocker one ulp smaller", lamp, {diamond_with_tip(down(2))}, focus});
}

/// Planes and lines at which a point begins or ceases to see something of one light behind one blocker.
void add_pair_events(Corpus& all) {
  add_tip_case(all, "separating_blocker_plane", "on a plane through a blocker edge and the farthest light vertex",
               {3, 3, 0});
  add_tip_case(all, "separating_light_plane", "on a plane through a light edge and a blocker vertex", {5, 0, 0});
  add_tip_case(all, "supporting_blocker_plane", "on a plane through a blocker edge that bounds the umbra", {1, 1, 0});
  add_tip_case(all, "vertex_and_vertex", "on a line through a light vertex and a blocker vertex", {5, 1, 0});
  const std::string aligned = "below parallel edges of light and blocker";
  all.push_back({"aligned_edges_exact", aligned, lamp, {board(-1, 1, -1, 1, 2)}, {3, 0, 0}});
  all.push_back({"aligned_edges_one_ulp_out",
                 aligned + ", the blocker one ulp larger",
                 lamp,
                 {board(-1, up(1), -1, 1, 2)},
                 {3, 0, 0}});
  all.push_back({"aligned_edges_one_ulp_in",
                 aligned + ", the blocker one ulp smaller",
                 lamp,
                 {board(-1, down(1), -1, 1, 2)},
                 {3, 0, 0}});
  all.push_back({"light_plane_exact", "in the light's plane", lamp, {blade(3, -1, 1, 3, 5)}, {5, 0, 4}});
  all.push_back(
      {"light_plane_one_ulp_below", "one ulp below the light's plane", lamp, {blade(3, -1, 1, 3, 5)}, {5, 0, down(4)}});
  all.push_back({"blocker_plane_exact", "in the blocker's plane", lamp, {diamond(2, 2)}, {5, 0, 2}});
  all.push_back(
      {"blocker_plane_one_ulp_below", "one ulp below the blocker's plane", lamp, {diamond(2, 2)}, {5, 0, down(2)}});
}

/// Events that take several blockers.
void add_group_events(Corpus& all) {
  const std::string edge_vertex = "in line with an edge of one blocker and a vertex of another";
  const auto wedge = [](double x) { return triangle({x, 0, 3}, {-2, 1, 3}, {-2, -1, 3}); };
  for (const auto& [name, x] : {std::pair{"exact", 0.0}, {"one_ulp_out", up(0.0)}, {"one_ulp_in", down(0.0)}}) {
    all.push_back(
        {std::string("edge_and_vertex_") + name, edge_vertex, lamp, {board(-3, 0, -3, 3, 1), wedge(x)}, {0, 0.5, 0}});
  }
  const std::string three = "in line with edges of three blockers";
  for (const auto& [name, x] : {std::pair{"exact", 0.0}, {"one_ulp_out", 0x1p-52}, {"one_ulp_in", -0x1p-52}}) {
    all.push_back({std::string("triple_edge_") + name,
                   three,
                   lamp,
                   {board(-3, 3, -3, 0, 1), triangle({-3, -3, 2}, {3, 3, 2}, {-3, 3, 2}), board(x, 3, -3, 3, 3)},
                   {0, 0, 0}});
  }
}

/// Large coordinates with small detail, and large things beside small ones.
void add_scales(Corpus& all) {
  for (const auto& [name, far] : {std::pair{"1e6", 1e6}, {"1e9", 1e9}, {"1e12", 1e12}}) {
    const Point3 offset{far, -far, far};
    all.push_back({std::string("far_offset_") + name,
                   std::string("unit detail at a distance of ") + name,
                   mapped(lamp, 1, offset),
                   {mapped(diamond(2, 2), 1, offset)},
                   sum({3, 3, 0}, offset)});
  }
  all.push_back(
      {"tiny_blocker", "a blocker a billionth as large as the light", lamp, {diamond(0x1p-30, 2)}, {0, 0, 0}});
  all.push_back({"tiny_light",
                 "a light a billionth as large as the blocker",
                 square_light(0x1p-30, 4),
                 {diamond(2, 2)},
                 {2, 2, 0}});
  all.push_back({"tiny_gap",
                 "the blocker a billionth of the distance below the light",
                 lamp,
                 {diamond(0.75, 4 - 0x1p-30)},
                 {0, 0, 0}});
}

void add_needles(Corpus& all) {
  const double far = 5e8;
  const AreaLight strip{ConvexPolygon::from_points({{-far, 0, 4}, {-far, 1, 4}, {far, 1, 4}, {far, 0, 4}})};
  const ConvexBlocker along = triangle({-far, 0, 2}, {far, 0.5, 2}, {far, 1, 2});
  const ConvexBlocker across = triangle({0, -far, 2}, {1, far, 2}, {0.5, far, 2});
  all.push_back({"needle_blocker", "a triangle a billion times as long as wide", lamp, {along}, {0, 0.75, 0}});
  all.push_back({"needle_light", "a light a billion times as long as wide", strip, {diamond(2, 2)}, {0, 0, 0}});
  all.push_back({"needles_along", "both of them, in the same direction", strip, {along}, {0, 0.5, 0}});
  all.push_back({"needles_across", "both of them, across", strip, {across}, {0, 0.5, 0}});
}

void add_grazing(Corpus& all) {
  const AreaLight window{ConvexPolygon::from_points({{0, -1, 0}, {0, 1, 0}, {0, 1, 0x1p-10}, {0, -1, 0x1p-10}})};
  all.push_back({"grazing_receiver",
                 "a low window seen from a floor far away",
                 window,
                 {blade(1, -2, 2, -1, 0x1p-11)},
                 {1000, 0, 0}});
  all.push_back({"grazing_light",
                 "a billionth below the light's plane, behind a blade that cuts it",
                 lamp,
                 {blade(2, -0.5, 0.5, 4 - 0x1p-31, 5)},
                 {4, 0, 4 - 0x1p-30}});
  all.push_back({"light_edge_in_blocker_plane_exact",
                 "a light edge in the blocker's plane",
                 lamp,
                 {blade(1, -2, 2, 1, 3)},
                 {1, 0, 0}});
  all.push_back({"light_edge_in_blocker_plane_one_ulp_out",
                 "a light edge one ulp beside the blocker's plane",
                 lamp,
                 {blade(up(1), -2, 2, 1, 3)},
                 {1, 0, 0}});
  all.push_back({"light_edge_in_blocker_plane_one_ulp_in",
                 "a light edge one ulp beyond the blocker's plane",
                 lamp,
                 {blade(down(1), -2, 2, 1, 3)},
                 {1, 0, 0}});
  all.push_back(
      {"blocker_in_light_plane", "light and blocker in one plane", lamp, {board(2, 3, -1, 1, 4)}, {5, 0, down(4)}});
  all.push_back({"blocker_one_ulp_below_light",
                 "the blocker's plane one ulp below the light's",
                 lamp,
                 {board(2, 3, -1, 1, down(4))},
                 {5, 0, 4 - 0x1p-40}});
}

void add_contacts(Corpus& all) {
  all.push_back({"nearly_touching", "the blocker one ulp below the light", lamp, {diamond(0.5, down(4))}, {0, 0, 0}});
  all.push_back({"touching_edge", "an edge of the blocker on the light", lamp, {blade(0, -0.5, 0.5, 3, 4)}, {1, 0, 0}});
  all.push_back({"touching_vertex",
                 "a vertex of the blocker on the light",
                 lamp,
                 {triangle({0, 0, 4}, {0.5, -0.5, 3}, {0.5, 0.5, 3})},
                 {1, 0, 0}});
  all.push_back({"shared_edge",
                 "light and blocker share an edge",
                 lamp,
                 {triangle({1, -1, 4}, {1, 1, 4}, {0.5, 0, 3})},
                 {2, 0, 0}});
  all.push_back(
      {"interpenetrating", "the blocker cuts through the light", lamp, {blade(0, -0.5, 0.5, 3, 5)}, {1, 0, 0}});
  std::vector<Point3> box;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {3.5, 4.5}) box.push_back({x, y, z});
    }
  }
  all.push_back(
      {"solid_through_light", "a box cuts through the light", lamp, {ConvexSolid::hull_of(box)}, {1, 0.5, 0}});
}

void add_coincidences(Corpus& all) {
  const ConvexBlocker left = board(-3, 0, -3, 3, 2), right = board(0, 3, -3, 3, 2);
  all.push_back({"coincident_blockers",
                 "the same blocker three times",
                 lamp,
                 {diamond(2, 2), diamond(2, 2), diamond(2, 2)},
                 {3, 3, 0}});
  all.push_back(
      {"abutting_blockers", "two boards with a common edge: no light between them", lamp, {left, right}, {0, 0, 0}});
  all.push_back({"gap_of_one_ulp",
                 "two boards one ulp apart: light between them",
                 lamp,
                 {left, board(std::numeric_limits<double>::denorm_min(), 3, -3, 3, 2)},
                 {0, 0, 0}});
  const double third = 1.0 / 3;
  const Point3 a{-3, -3, 2}, b{3, -3, 2}, c{3, 3, 2}, d{-3, 3, 2}, m{third, third * third, 2};
  all.push_back({"abutting_triangles",
                 "four triangles around a vertex: no light between them",
                 lamp,
                 {triangle(a, b, m), triangle(b, c, m), triangle(c, d, m), triangle(d, a, m)},
                 {third, 0, 0}});
  all.push_back({"overlapping_coplanar",
                 "boards of one plane that overlap",
                 lamp,
                 {board(-1, 0.5, -1, 1, 2), board(-0.5, 1, -1, 1, 2)},
                 {3, 0, 0}});
  all.push_back({"edges_seen_in_one",
                 "edges of two blockers at two heights, seen as one",
                 lamp,
                 {board(-3, 0, -3, 3, 2), board(0, 3, -3, 3, 1)},
                 {0, 0, 0}});
}

void add_corners(Corpus& all) {
  std::vector<Point3> round = flat_round(1000, 1, 4);
  std::reverse(round.begin(), round.end());
  all.push_back({"thousand_gon_blocker",
                 "a blocker of a thousand corners",
                 lamp,
                 {ConvexPolygon::from_points(flat_round(1000, 1, 2))},
                 {2, 0, 0}});
  all.push_back({"thousand_gon_light",
                 "a light of a thousand corners",
                 {ConvexPolygon::from_points(round)},
                 {diamond(1, 2)},
                 {2, 0, 0}});
}

/// The quads of a turned cube, each rounded off its plane: slivers.
std::vector<ConvexBlocker> cube_faces(const std::vector<Point3>& c) {
  std::vector<ConvexBlocker> faces;
  for (const auto& [i, j, k, l] :
       {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    const auto at = [&](int n) { return c[static_cast<std::size_t>(n)]; };
    faces.push_back(convex_blocker(ConvexPolygon::from_points({at(i), at(j), at(k), at(l)})));
  }
  return faces;
}

void add_rounded(Corpus& all) {
  const std::vector<Point3> cube = turned_cube({0.25, 0.125, 1.75}, 0.7);
  all.push_back({"rotated_cube",
                 "a cube whose faces are rounded off their planes",
                 lamp,
                 {ConvexSolid::hull_of(cube)},
                 {3, 2, -1}});
  all.push_back({"rotated_cube_of_faces", "its faces one by one", lamp, cube_faces(cube), {3, 2, -1}});
  const std::vector<Point3> second = turned_cube({0.25, 0.125, 1.75}, 2.1);
  all.push_back({"rotated_cubes",
                 "two of them, one in the other",
                 lamp,
                 {ConvexSolid::hull_of(cube), ConvexSolid::hull_of(second)},
                 {3, 2, -1}});
  const std::vector<Point3> far = turned_cube({0, 0, 6}, 0.3);
  all.push_back({"rotated_light",
                 "a light whose corners are rounded off its plane",
                 {ConvexPolygon::from_points({far[0], far[2], far[6], far[4]}), true},
                 {diamond(1, 2)},
                 {1, 1, 0}});
}

/// Scaled by powers of two, so that nothing but the size changes.
void add_sizes(Corpus& all) {
  const std::tuple<const char*, const char*, int> sizes[] = {
      {"subnormal", "coordinates below the smallest normal double", -1070},
      {"underflowing", "coordinates whose products underflow", -400},
      {"near_fast_limit", "coordinates near 1e30, as large as the fast level takes", 97},
      {"beyond_fast_limit", "coordinates beyond 1e30", 110},
      {"overflowing", "coordinates whose products overflow", 1000}};
  for (const auto& [name, about, exponent] : sizes) {
    const double factor = std::ldexp(1.0, exponent);
    all.push_back(
        {name, about, mapped(lamp, factor, {}), {mapped(diamond(2, 2), factor, {})}, scaled(factor, {3, 3, 0})});
  }
}

}  // namespace

std::vector<HardCase> hard_cases() {
  Corpus all;
  add_pair_events(all);
  add_group_events(all);
  add_scales(all);
  add_needles(all);
  add_grazing(all);
  add_contacts(all);
  add_coincidences(all);
  add_corners(all);
  add_rounded(all);
  add_sizes(all);
  return all;
}

}  // namespace gnomon::report
