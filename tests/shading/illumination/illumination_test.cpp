#include "gnomon/illumination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "gnomon/errors.h"
#include "gnomon/view_factors.h"

namespace gnomon {
namespace {

using Polygons = std::vector<ConvexPolygon>;

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

ConvexBlocker block(const Point3& low, const Point3& high) {
  std::vector<Point3> points;
  for (int c = 0; c < 8; ++c) {
    points.push_back({c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z});
  }
  return ConvexSolid::hull_of(std::move(points));
}

const ConvexPolygon ground = polygon({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}});
const Light square_lamp = AreaLight{polygon({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
const Light small_lamp = AreaLight{polygon({{2, 2, 3}, {2, 2.5, 3}, {2.5, 2.5, 3}, {2.5, 2, 3}})};
const Light skew_tube = LinearLight{{-2, -1, 3}, {1, -2, 2}};

/// On the floor, touching each other along an edge, and a board that stands on it.
const Obstacles furniture{{block({-2, -1, 0}, {-1, 1, 1}), block({-1, 1, 0}, {0, 2, 2}),
                           polygon({{1, -2, 0}, {2, -1, 0}, {2, -1, 1.5}, {1, -2, 1.5}})},
                          {}};

Irradiance exact_sum(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
                     const ConvexPolygon& receiver, const Point3& p) {
  std::vector<Irradiance> parts;
  const auto points = receiver.points();
  const double turn = (points[1].x - points[0].x) * (points[2].y - points[0].y) -
                      (points[1].y - points[0].y) * (points[2].x - points[0].x);
  for (const IlluminationLight& light : lights) {
    for (const Light& part : light.parts) {
      LightIrradiance irradiance(part, light.strength, PreparedObstacles(obstacles));
      parts.push_back(irradiance.received({p, facet_front(receiver)}, {0, 0, turn > 0 ? 1.0 : -1.0}));
    }
  }
  return total_irradiance(parts);
}

/// What a face interpolates at shares of its corners that sum up to 1.
double interpolated(const IlluminationMesh& mesh, const IlluminationFace& face, int order,
                    const std::array<double, 3>& w) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (order == 1) {
      sum += w[k] * mesh.irradiance[face.corners[k]].value;
    } else {
      sum += w[k] * (2 * w[k] - 1) * mesh.irradiance[face.corners[k]].value +
             4 * w[k] * w[(k + 1) % 3] * mesh.irradiance[face.middles[k]].value;
    }
  }
  return sum;
}

Point3 place(const IlluminationMesh& mesh, const IlluminationFace& face, const std::array<double, 3>& w) {
  Point3 p{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& c = mesh.points[face.corners[k]];
    p = {p.x + w[k] * c.x, p.y + w[k] * c.y, p.z + w[k] * c.z};
  }
  return p;
}

struct Agreement {
  std::size_t asked = 0;
  std::size_t beyond_error = 0;  ///< of its face
  double worst = 0;              ///< as a share of the tolerance
};

/// Random places of random faces, wider ones more often.
Agreement agreement(std::span<const IlluminationLight> lights, const Obstacles& obstacles, const Illumination& found,
                    int order, std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> share(0.001, 0.999);
  const IlluminationMesh& mesh = found.meshes.front();
  std::vector<double> areas;
  for (const IlluminationFace& face : mesh.faces) {
    const Point3 &a = mesh.points[face.corners[0]], &b = mesh.points[face.corners[1]],
                 &c = mesh.points[face.corners[2]];
    areas.push_back(0.01 + std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
  }
  std::discrete_distribution<std::size_t> some_face(areas.begin(), areas.end());
  Agreement tally;
  for (; tally.asked < count; ++tally.asked) {
    const IlluminationFace& face = mesh.faces[some_face(engine)];
    const double root = std::sqrt(share(engine)), second = share(engine);
    const std::array<double, 3> w{1 - root, root * (1 - second), root * second};
    const Irradiance exact = exact_sum(lights, obstacles, ground, place(mesh, face, w));
    const double off = std::fabs(exact.value - interpolated(mesh, face, order, w)) - exact.error_bound;
    if (face.is_met) tally.worst = std::max(tally.worst, off / found.tolerance);
    tally.beyond_error += off > face.error ? 1 : 0;
  }
  return tally;
}

constexpr std::size_t point_count = GNOMON_LONG ? 1000000 : 10000;

class Illuminates : public ::testing::TestWithParam<int> {};

TEST_P(Illuminates, ToWithinTheToleranceAtRandomPlaces) {
  const std::vector<IlluminationLight> lights = {
      {{square_lamp}, 1}, {{skew_tube}, 0.05}, {{PointLight{{3, -3, 2}}}, 0.1}};
  IlluminationEffort effort;
  effort.order = GetParam();
  effort.tolerance = 0.02;
  for (const IlluminationSplit split : {IlluminationSplit::need, IlluminationSplit::all, IlluminationSplit::none}) {
    effort.split = split;
    const Illumination found = illuminate(lights, furniture, {&ground, 1}, effort);
    EXPECT_EQ(found.meshes.front().unmet_faces(), 0U);
    EXPECT_LE(found.meshes.front().largest_error(), found.tolerance);
    const Agreement tally = agreement(lights, furniture, found, effort.order, point_count / 3, 7);
    std::cout << "order " << effort.order << ": " << found.meshes.front().faces.size() << " faces, worst "
              << tally.worst << " of the tolerance, " << tally.beyond_error << " of " << tally.asked
              << " places beyond their face's error\n";
    EXPECT_LE(tally.worst, 1.1);
    EXPECT_LE(1000 * tally.beyond_error, 2 * tally.asked);
  }
}

INSTANTIATE_TEST_SUITE_P(OfOrder, Illuminates, ::testing::Values(1, 2));

/// An edge by the coordinates of its ends.
using Place = std::array<double, 3>;
using EdgePlaces = std::pair<Place, Place>;

Place place_of(const Point3& p) {
  return {p.x, p.y, p.z};
}

std::map<EdgePlaces, int> faces_at_edges(const Illumination& found) {
  std::map<EdgePlaces, int> count;
  for (const IlluminationMesh& mesh : found.meshes) {
    for (const IlluminationFace& face : mesh.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Place a = place_of(mesh.points[face.corners[k]]), b = place_of(mesh.points[face.corners[(k + 1) % 3]]);
        ++count[std::minmax(a, b)];
      }
    }
  }
  return count;
}

TEST(Illumination, HasNoCornerInsideAnothersEdgeAcrossReceiversOfOneWall) {
  // The floor in three pieces, two of which share a side with the third's ... and the whole border.
  const Polygons pieces = {polygon({{-4, -4, 0}, {0.5, -4, 0}, {0.5, 4, 0}, {-4, 4, 0}}),
                           polygon({{0.5, -4, 0}, {4, -4, 0}, {4, 4, 0}, {0.5, 4, 0}})};
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{small_lamp}, 3}};
  for (const int order : {1, 2}) {
    const Illumination found = illuminate(lights, furniture, pieces, {.tolerance = 0.03, .order = order});
    const auto is_border = [](const EdgePlaces& e) {
      const auto lies = [&](std::size_t axis, double at) { return e.first[axis] == at && e.second[axis] == at; };
      return lies(0, -4) || lies(0, 4) || lies(1, -4) || lies(1, 4);
    };
    for (const auto& [edge, count] : faces_at_edges(found)) {
      EXPECT_EQ(count, is_border(edge) ? 1 : 2)
          << edge.first[0] << ',' << edge.first[1] << " to " << edge.second[0] << ',' << edge.second[1];
    }
    EXPECT_NEAR(found.meshes[0].area() + found.meshes[1].area(), 64, 1e-12);
  }
}

TEST(Illumination, HasBothSidesOfAReceiverAndOfItsNeighbour) {
  const Point3 a{-2, -2, 0}, b{2, -2, 0}, c{2, 2, 0}, d{-2, 2, 0}, e{4, -2, 0}, f{4, 2, 0};
  const Polygons sides{polygon({a, b, c, d}), polygon({d, c, b, a}), polygon({b, e, f, c}), polygon({c, f, e, b})};
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{PointLight{{0.5, 0.25, -3}}}, 2}};
  const Illumination found = illuminate(lights, {{block({-1, -1, 1}, {1, 0, 2})}, {}}, sides, {});
  const std::array<double, 4> areas{16, 16, 8, 8};
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_NEAR(found.meshes[r].area(), areas[r], 1e-9) << r;
    EXPECT_EQ(found.meshes[r].unmet_faces(), 0u);
    const Irradiance exact = exact_sum(lights, {{block({-1, -1, 1}, {1, 0, 2})}, {}}, sides[r], sides[r].points()[0]);
    const auto told = IlluminationField(found.meshes[r]).at(sides[r].points()[0]);
    ASSERT_TRUE(told);
    EXPECT_NEAR(told->value, exact.value, found.tolerance);
    EXPECT_GT(told->value, 0);
  }
}

TEST(Illumination, IsTheSameForAnyNumberOfThreads) {
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{skew_tube}, 0.05}};
  const auto made = [&](unsigned threads) {
    return illuminate(lights, furniture, {&ground, 1}, {.tolerance = 0.02, .threads = threads});
  };
  const Illumination one = made(1), three = made(3);
  ASSERT_EQ(one.meshes[0].points.size(), three.meshes[0].points.size());
  EXPECT_EQ(one.evaluations, three.evaluations);
  for (std::size_t i = 0; i < one.meshes[0].points.size(); ++i) {
    EXPECT_EQ(place_of(one.meshes[0].points[i]), place_of(three.meshes[0].points[i]));
    EXPECT_EQ(one.meshes[0].irradiance[i].value, three.meshes[0].irradiance[i].value);
  }
}

TEST(Illumination, TellsFacesWhileAReceiverIsMeshed) {
  const IlluminationLight light{{square_lamp}, 1};
  const Polygons both = {ground, polygon({{-4, 4, 0}, {4, 4, 0}, {4, 4, 3}, {-4, 4, 3}})};
  std::vector<std::array<std::size_t, 3>> told;
  IlluminationEffort effort;
  effort.progress = [&](std::size_t done, std::size_t of, std::size_t faces) { told.push_back({done, of, faces}); };
  const Illumination found = illuminate({&light, 1}, furniture, both, effort);
  const std::size_t first = found.meshes[0].faces.size(), second = found.meshes[1].faces.size();
  EXPECT_EQ(told.front()[0], 0U);
  EXPECT_LT(told.front()[2], first);
  EXPECT_NE(std::ranges::find(told, std::array<std::size_t, 3>{1, 2, first}), told.end());
  EXPECT_EQ(told.back(), (std::array<std::size_t, 3>{2, 2, first + second}));
}

TEST(Illumination, OfSeveralLightsIsTheSumOfWhatEachGives) {
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{skew_tube}, 0.05}};
  const Illumination found = illuminate(lights, furniture, {&ground, 1}, {.tolerance = 0.05});
  const IlluminationMesh& mesh = found.meshes[0];
  ASSERT_EQ(mesh.of_lights.size(), 2U);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Irradiance parts[] = {mesh.of_lights[0][i], mesh.of_lights[1][i]};
    EXPECT_EQ(mesh.irradiance[i].value, total_irradiance(parts).value);
  }
}

TEST(Illumination, HasTheFluxOfTheViewFactor) {
  // Nothing between, and a board between: pi times radiance, area and factor.
  const ConvexPolygon desk = polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const ConvexPolygon lamp = std::get<AreaLight>(square_lamp).polygon;
  const ConvexBlocker board = polygon({{-0.5, -0.5, 2}, {0.7, -0.5, 2}, {0.7, 0.5, 2.5}, {-0.5, 0.5, 2.5}});
  for (const Obstacles& obstacles : {Obstacles{}, Obstacles{{board}, {}}}) {
    const ViewSurface surfaces[] = {{desk}, {lamp}};
    const double factor = view_factors(surfaces, obstacles, {}).factors.front().value;
    const IlluminationLight light{{square_lamp}, 2};
    for (const double tolerance : {0.05, 0.005}) {
      const Illumination found = illuminate({&light, 1}, obstacles, {&desk, 1}, {.tolerance = tolerance});
      const IlluminationMesh& mesh = found.meshes[0];
      EXPECT_NEAR(mesh.flux(), std::numbers::pi * 2 * 4 * factor, mesh.flux_error());
      EXPECT_LE(mesh.flux_error(), 4 * found.tolerance);
    }
  }
}

Light scaled(const Light& light, double s) {
  const auto at = [&](const Point3& p) { return Point3{s * p.x, s * p.y, s * p.z}; };
  if (const auto* tube = std::get_if<LinearLight>(&light)) return LinearLight{at(tube->start), at(tube->end)};
  if (const auto* bulb = std::get_if<PointLight>(&light)) return PointLight{at(bulb->position)};
  std::vector<Point3> points;
  for (const Point3& p : std::get<AreaLight>(light).polygon.points()) points.push_back(at(p));
  return AreaLight{polygon(points)};
}

ConvexPolygon scaled(const ConvexPolygon& shape, double s) {
  return std::get<AreaLight>(scaled(Light(AreaLight{shape}), s)).polygon;
}

TEST(Illumination, OfASceneTwiceAsLargeIsTheSameToTheBit) {
  const ConvexPolygon board = polygon({{1, -2, 0}, {2, -1, 0}, {2, -1, 1.5}, {1, -2, 1.5}});
  const std::pair<Light, double> cases[] = {{square_lamp, 1}, {skew_tube, 2}, {PointLight{{3, -3, 2}}, 4}};
  for (const auto& [light, falls] : cases) {
    const auto made = [&, source = light](double s) {
      const IlluminationLight one{{scaled(source, s)}, 1};
      const ConvexPolygon floor = scaled(ground, s);
      return illuminate({&one, 1}, {{scaled(board, s)}, {}}, {&floor, 1}, {.tolerance = 0.03}).meshes[0];
    };
    const IlluminationMesh small = made(1), large = made(2);
    ASSERT_EQ(small.points.size(), large.points.size());
    for (std::size_t i = 0; i < small.points.size(); ++i) {
      EXPECT_EQ(2 * small.points[i].x, large.points[i].x);
      EXPECT_EQ(small.irradiance[i].value, falls * large.irradiance[i].value);
    }
  }
}

/// What is interpolated at a place of the ground.
double interpolated_at(const IlluminationMesh& mesh, int order, const Point3& p) {
  const auto turn = [](const Point3& a, const Point3& b, const Point3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  for (const IlluminationFace& face : mesh.faces) {
    const auto corner = [&](std::size_t k) { return mesh.points[face.corners[k]]; };
    const double whole = turn(corner(0), corner(1), corner(2));
    const std::array<double, 3> w{turn(p, corner(1), corner(2)) / whole, turn(corner(0), p, corner(2)) / whole,
                                  turn(corner(0), corner(1), p) / whole};
    if (std::min({w[0], w[1], w[2]}) >= 0) return interpolated(mesh, face, order, w);
  }
  return HUGE_VAL;
}

/// No edge of the lamp is parallel to one of the blocker, so all lines are of order 2, and none has to be cut along.
TEST_P(Illuminates, ASmallShadowThatNoLineOfOrderOneBounds) {
  const std::vector<IlluminationLight> lights = {
      {{AreaLight{polygon({{-0.1, -0.07, 4}, {0.01, 0.12, 4}, {0.13, -0.02, 4}})}}, 100}};
  for (const Point3 at : {Point3{0.3, 0.2, 0}, Point3{-1.7, 0.9, 0}, Point3{2.1, -1.3, 0}}) {
    const Obstacles board{
        {polygon({{at.x, at.y, 0.25}, {at.x + 0.05, at.y + 0.011, 0.26}, {at.x + 0.02, at.y + 0.06, 0.28}})}, {}};
    IlluminationEffort effort;
    effort.order = GetParam();
    effort.tolerance = 0.02;
    for (const IlluminationSplit split : {IlluminationSplit::none, IlluminationSplit::need, IlluminationSplit::all}) {
      effort.split = split;
      const Illumination found = illuminate(lights, board, Polygons{ground}, effort);
      double worst = 0;
      for (int i = -9; i <= 12; ++i) {
        for (int j = -9; j <= 12; ++j) {
          const Point3 p{at.x * (1 + 0.25 / 3.75) + i * 0.01, at.y * (1 + 0.25 / 3.75) + j * 0.01, 0};
          const Irradiance exact = exact_sum(lights, board, ground, p);
          worst = std::max(worst, std::fabs(exact.value - interpolated_at(found.meshes[0], effort.order, p)));
        }
      }
      EXPECT_LT(worst, found.tolerance) << at.x << ", " << static_cast<int>(split);
      EXPECT_EQ(found.meshes[0].unmet_faces(), 0u);
    }
  }
}

TEST(Illumination, TakesFewFacesUnderABoardThatNearlyTouches) {
  const IlluminationLight light{{square_lamp}, 1};
  const auto faces = [&](double height) {
    const double z = height;
    const ConvexBlocker board = polygon({{-1, -1, z}, {1, -1.5, z}, {1.5, 1, z}, {-0.5, 1, z}});
    const Illumination found = illuminate({&light, 1}, {{board}, {}}, {&ground, 1}, {.tolerance = 0.02});
    EXPECT_EQ(found.meshes[0].unmet_faces(), 0U) << height;
    return found.meshes[0].faces.size();
  };
  EXPECT_LT(faces(1e-6), 1000U);
  EXPECT_LT(faces(0), 400U);
}

/// Arcs end on traces at places that are no doubles.
TEST(IlluminationDegenerate, HasNoFaceWithoutAreaWhereArcsEnd) {
  const Light lamp =
      AreaLight{polygon({{0.578125, 0.078125, 4.78125}, {0.578125, 1.5625, 5.5}, {1.96875, 0.078125, 4.84375}})};
  const ConvexSolid spike = ConvexSolid::hull_of({{-1.953125, -2.140625, 0.640625},
                                                  {-1.390625, -2.640625, 0},
                                                  {-1.375, -2.171875, 0.296875},
                                                  {-1.90625, -2.09375, 0.890625}});
  const Obstacles both{{spike, block({-0.953125, -2.640625, 0}, {-0.625, -1.875, 1.015625})}, {}};
  const IlluminationLight light{{lamp}, 1};
  const Illumination found = illuminate({&light, 1}, both, {&ground, 1}, {.tolerance = 5e-3});
  const IlluminationMesh& mesh = found.meshes.front();
  EXPECT_EQ(mesh.unmet_faces(), 0U);
  for (const IlluminationFace& face : mesh.faces) {
    const Point3 &a = mesh.points[face.corners[0]], &b = mesh.points[face.corners[1]],
                 &c = mesh.points[face.corners[2]];
    EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 1e-8) << a.x << ' ' << a.y;
  }
}

/// An arc of one lamp ends on a trace of both, at a place that is not rational.
TEST(IlluminationDegenerate, HasNoFaceWithoutAreaWhereAnArcEndsOnATraceOfSeveralLights) {
  const IlluminationLight lamps[] = {
      {{AreaLight{polygon({{-0.53125, 0.453125, 4.890625},
                           {-0.53125, 1.609375, 4.890625},
                           {-0.15625, 1.609375, 5.236328125},
                           {-0.15625, 0.453125, 5.236328125}})}},
       1},
      {{AreaLight{polygon({{-4, -1, 1.875}, {-4, 1, 1.875}, {-4, 1, 3.875}, {-4, -1, 3.875}})}}, 1}};
  const auto board = [](const Point3& a, const Point3& b, double top) {
    return polygon({a, b, {b.x, b.y, top}, {a.x, a.y, top}});
  };
  const Obstacles boards{{board({0.859375, -0.59375, 0}, {1.53125, -1.359375, 0}, 0.65625),
                          board({0.265625, -0.4375, 0}, {0, -0.46875, 0}, 1.5),
                          board({2.5, -0.71875, 0}, {1.84375, -1.28125, 0}, 0.328125)},
                         {}};
  const Illumination found = illuminate(lamps, boards, {&ground, 1}, {.tolerance = 0.05, .most_faces = 4000});
  const IlluminationMesh& mesh = found.meshes.front();
  EXPECT_EQ(mesh.unmet_faces(), 0U);
  for (const IlluminationFace& face : mesh.faces) {
    IlluminationMesh alone;
    alone.points = mesh.points;
    alone.faces = {face};
    EXPECT_GT(alone.area(), 1e-10);
  }
}

/// Turned by angles that leave no coordinate short.
std::vector<Point3> turned(std::vector<Point3> points, double by) {
  const double c = std::cos(by), s = std::sin(by), d = std::cos(3 * by), e = std::sin(3 * by);
  for (Point3& p : points) {
    const double x = c * p.x - s * p.y, y = s * p.x + c * p.y;
    p = {x, d * y - e * p.z, e * y + d * p.z};
  }
  return points;
}

/// A trace that ends on the border of the receiver's plane ends beside the line between two vertices.
TEST(IlluminationDegenerate, OfARoundedReceiverHasNoFaceWithoutAreaAtItsBorder) {
  std::size_t rounded = 0;
  for (const double by : {0.1, 0.21, 0.32, 0.43, 0.54, 0.65}) {
    const ConvexPolygon floor = polygon(turned({{-4, -4, 0}, {4, -4, 0}, {4.3, 3.7, 0}, {-4, 4.1, 0}}, by));
    rounded += floor.is_flat() ? 0 : 1;
    const std::vector<Point3> ends = turned({{-2, -1, 3}, {1, -2, 2}}, by);
    const IlluminationLight light{{LinearLight{ends[0], ends[1]}}, 1};
    std::vector<Point3> box;
    for (int c = 0; c < 8; ++c) box.push_back({c & 1 ? 3.0 : 2.0, c & 2 ? 3.5 : -2.5, c & 4 ? 2.0 : 1.0});
    const Obstacles obstacles{{ConvexSolid::hull_of(turned(box, by))}, {}};
    const Illumination found = illuminate({&light, 1}, obstacles, {&floor, 1}, {.tolerance = 0.05});
    const IlluminationMesh& mesh = found.meshes.front();
    EXPECT_EQ(mesh.unmet_faces(), 0U) << by;
    for (const IlluminationFace& face : mesh.faces) {
      IlluminationMesh alone;
      alone.points = mesh.points;
      alone.faces = {face};
      EXPECT_GT(alone.area(), 1e-6) << by;
    }
  }
  EXPECT_GT(rounded, 3U);
}

/// Where an edge of a lamp pierces the ground irradiance has many limits, at places that are no doubles.
TEST(IlluminationDegenerate, MeetsTheToleranceAroundEdgesThatPierceTheReceiver) {
  const Light through = AreaLight{polygon({{-3, -1, -0.7}, {-3, 1, -0.7}, {-2.5, 1, 1.4}, {-2.5, -1, 1.4}})};
  const Light on_one_side = AreaLight{polygon({{-4, -1, -0.5}, {-4, 1, -0.5}, {-4, 1, 1.5}, {-4, -1, 1.5}})};
  const Obstacles boards{{polygon({{-1.5, -1.25, 1.5}, {-0.9, -1.25, 1.5}, {-0.9, -0.5, 1.5}, {-1.5, -0.5, 1.5}}),
                          polygon({{2, 0, -0.3}, {3, 0.5, -0.3}, {3.5, 0.75, 0.4}, {2.5, 0.25, 0.4}})},
                         {}};
  IlluminationEffort effort;
  effort.tolerance = 0.05;
  effort.most_faces = 8000;
  for (const Light& lamp : {through, on_one_side}) {
    const std::vector<IlluminationLight> lights = {{{lamp}, 1}, {{small_lamp}, 4}};
    const Illumination found = illuminate(lights, boards, {&ground, 1}, effort);
    EXPECT_EQ(found.meshes.front().unmet_faces(), 0U);
    const Agreement tally = agreement(lights, boards, found, 1, 2000, 11);
    std::cout << found.meshes.front().faces.size() << " faces, worst " << tally.worst << " of the tolerance\n";
    EXPECT_LE(tally.worst, 1.1);
  }
}

TEST(IlluminationDegenerate, TellsOfFacesAroundALightOnTheReceiver) {
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{LinearLight{{1, 1, 0}, {1, 1, 1}}}, 1}};
  const Illumination found = illuminate(lights, {}, {&ground, 1}, {.tolerance = 0.1, .most_faces = 5000});
  EXPECT_TRUE(std::isfinite(found.largest));
  EXPECT_GT(found.meshes[0].unmet_faces(), 0U);
  EXPECT_LT(found.meshes[0].unmet_area(), 0.5);
}

TEST(IlluminationField, IsWhatTheFaceAroundAPlaceInterpolates) {
  const std::vector<IlluminationLight> lights = {{{square_lamp}, 1}, {{PointLight{{3, -3, 2}}}, 0.1}};
  const Polygons upright{ground, polygon({{-4, 4, 0}, {4, 4, 0}, {4, 4, 3}, {-4, 4, 3}})};
  for (const int order : {1, 2}) {
    IlluminationEffort effort;
    effort.order = order;
    const Illumination found = illuminate(lights, furniture, upright, effort);
    const IlluminationField floor(found.meshes[0]), wall(found.meshes[1]);
    std::mt19937 engine(20261201);
    std::uniform_real_distribution<double> across(-4, 4);
    std::size_t of_edges = 0;
    for (int i = 0; i < 3000; ++i) {
      const Point3 p{across(engine), across(engine), 0};
      const auto here = floor.at(p);
      ASSERT_TRUE(here);
      // At a jump either face may be asked, but for the first found in the mesh's order.
      of_edges += std::fabs(here->value - interpolated_at(found.meshes[0], order, p)) > 1e-12 * found.largest;
      EXPECT_LE(here->error_bound, found.tolerance);
    }
    EXPECT_LE(of_edges, 1u);
    for (const IlluminationFace& face : found.meshes[1].faces) {
      const std::array<double, 3> w{0.5, 0.375, 0.125};
      const auto here = wall.at(place(found.meshes[1], face, w));
      ASSERT_TRUE(here);
      EXPECT_NEAR(here->value, interpolated(found.meshes[1], face, order, w), 1e-9 * found.largest);
    }
  }
}

TEST(IlluminationField, IsNowhereOutsideTheReceiverAndEverywhereOnItsBorder) {
  const double turn = std::numbers::sqrt3 / 2;
  const ConvexPolygon turned =
      polygon({{1e3, 0, 0}, {1e3 + turn, 0.5, 0}, {1e3 + turn - 0.5, 0.5 + turn, 0}, {1e3 - 0.5, turn, 0}});
  const Illumination found =
      illuminate(std::vector<IlluminationLight>{{{PointLight{{1e3, 1, 1}}}, 1}}, {}, Polygons{turned}, {});
  const IlluminationField field(found.meshes[0]);
  const auto points = turned.points();
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3 a = points[k], b = points[(k + 1) % 4];
    for (int i = 0; i <= 64; ++i) {
      const auto on = [&](double outward) {
        return Point3{a.x + (b.x - a.x) * i / 64 + outward * (b.y - a.y),
                      a.y + (b.y - a.y) * i / 64 - outward * (b.x - a.x), 0};
      };
      EXPECT_TRUE(field.at(on(0)));
      EXPECT_FALSE(field.at(on(1e-6)));
      EXPECT_FALSE(field.at(on(1e6)));
    }
  }
  EXPECT_FALSE(field.at({std::nan(""), 0, 0}));
  EXPECT_FALSE(IlluminationField(IlluminationMesh{}).at({0, 0, 0}));
}

TEST(IlluminationDegenerate, OfNothingIsDark) {
  const IlluminationLight behind{{PointLight{{0, 0, -1}}}, 1};
  const Illumination none = illuminate({}, {}, {&ground, 1}, {});
  const Illumination dark = illuminate({&behind, 1}, {}, {&ground, 1}, {});
  EXPECT_EQ(none.largest, 0);
  EXPECT_EQ(dark.largest, 0);
  EXPECT_EQ(dark.meshes[0].faces.size(), 2U);
  EXPECT_EQ(dark.meshes[0].unmet_faces(), 0U);
  EXPECT_TRUE(illuminate({&behind, 1}, {}, {}, {}).meshes.empty());
  EXPECT_THROW(illuminate({&behind, 1}, {}, {&ground, 1}, {.tolerance = 0}), PreconditionError);
  EXPECT_THROW(illuminate({&behind, 1}, {}, {&ground, 1}, {.tolerance = NAN}), PreconditionError);
}

}  // namespace
}  // namespace gnomon
