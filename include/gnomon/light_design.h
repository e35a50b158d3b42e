#pragma once

/// @file
/// From the wanted shadows to the light: every position that fulfils goals, one of them, and why there is none.
///
///     #include <gnomon/light_design.h>
///     int main() {
///       using namespace gnomon;
///       const auto shelf = ConvexPolygon::from_points({{12, -3, 12}, {18, -3, 12}, {18, 9, 12}, {12, 9, 12}});
///       DesignGoal pillow{.name = "pillow", .want = Want::dark, .subjects = {{{{18, 3, 0}}}}};
///       const Design track{.domain = {DomainShape::segment, {{0, 3, 24}, {24, 3, 24}}}, .goals = {pillow}};
///       const DesignResult result = solved_design(track, {{{shelf}, {}}, {"shelf"}, {"shelf"}}, {});
///       return result.status == DesignStatus::feasible && result.answer->exact[0].exact == "12" ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gnomon/point.h"
#include "gnomon/scene.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// What a goal asks of its subject: the regions of <gnomon/names.h>, or where the light may stand.
enum class Want {
  lit,       ///< no blocker hides any of the light
  shadow,    ///< some blocker hides some of it
  dark,      ///< nothing of it is seen
  penumbra,  ///< something of it is hidden, but not all
  edge,      ///< the subject, a point, lies on the shadow's boundary: the light on a plane through a blocker's edge
  nail,      ///< a blocker's vertex casts its shadow on the subject, a point
  no_reflection,  ///< an eye does not see the light mirrored in the subject, a flat receiver
  not_seen_from,  ///< the subject, a point, is an eye that does not see the light
  irradiance,     ///< lit, and at least so brightly
  diffuse_peak,   ///< the light stands on the normal of the subject, a point, and is not hidden from it
  highlight,      ///< an eye sees the light mirrored at the subject, a point: the highlight's peak
};

/// The word of goals files.
constexpr std::string_view name(Want want) {
  constexpr std::string_view names[] = {"lit",        "shadow",       "dark",          "penumbra",
                                        "edge",       "nail",         "no_reflection", "not_seen_from",
                                        "irradiance", "diffuse_peak", "highlight"};
  return names[static_cast<int>(want)];
}

/// A point, or a convex polygon: what is asked of a polygon holds for almost every point of it.
struct DesignSubject {
  std::vector<Point3> points;            ///< one, or the corners, counterclockwise seen from the front
  std::optional<ReceiverFront> front{};  ///< before which light is received; without one a subject has no side
};

/// One effect on one subject.
struct DesignGoal {
  std::string name;
  Want want = Want::lit;
  std::vector<DesignSubject> subjects;  ///< all of them: the pieces of one receiver
  std::string by = {};                  ///< of all blockers only this one counts; empty: all
  std::uint32_t element = 0;            ///< the edge of `edge`, the vertex of `nail`, as the blocker's file has them
  Point3 eye = {};                      ///< of `no_reflection` and `highlight`
  double at_least = 0;                  ///< of `irradiance`: of a light of intensity 1, lengths in the scene's unit
  std::optional<Point3> contour = {};   ///< of `highlight`: a point on the highlight's border, with the same normal
  double threshold = 0.5;               ///< and which share of the peak that border has
  Light light = PointLight{};           ///< of moved blockers: whose shadow is meant
};

/// What is sought.
enum class FreeVariable {
  position,     ///< of a point light
  direction,    ///< towards a directional light
  translation,  ///< by which a light is moved
  scale,        ///< of a light about a point: s > 0 is the x-coordinate
  blocker,      ///< by which a blocker is moved
};

constexpr std::string_view name(FreeVariable variable) {
  constexpr std::string_view names[] = {"position", "direction", "translation", "scale", "translation"};
  return names[static_cast<int>(variable)];
}

enum class DomainShape { everywhere, box, polytope, polygon, segment, polyline, directions };

/// Where the variable may be: all of space, or the hull or polygon or line of vertices, or the cone of directions.
struct DesignDomain {
  DomainShape shape = DomainShape::everywhere;
  std::vector<Point3> vertices = {};  ///< of a box its least and its largest corner
};

/// A task.
struct Design {
  FreeVariable variable = FreeVariable::position;
  Light light = PointLight{};  ///< that is moved or scaled
  std::string blocker = {};    ///< that is moved
  Point3 centre = {};          ///< of scaling
  DesignDomain domain = {};
  std::vector<DesignGoal> goals = {};
  double margin = 0;               ///< how far the answer stays from every boundary of the goals, at least
  double intensity = 1;            ///< of a point light: what `at_least` 1 is in the scene's irradiance
  std::string variable_name = {};  ///< of the light or blocker, for people
};

/// The convex parts of a scene's blockers with their names, and of each the name of its blocker.
struct DesignObstacles {
  Obstacles obstacles;
  std::vector<std::string> parts;
  std::vector<std::string> elements;
};

DesignObstacles design_obstacles(const SpaceScene& scene);

/// What a plane that bounds feasible positions comes from.
struct DesignWall {
  enum class Kind {
    domain,  ///< `edge` is the side of a box, the facet, edge or end of another domain
    front,   ///< the plane of a receiver, or of a goal without a blocker
    shadow,  ///< of `part`, named by its edge and the subject's vertex as FacetName says
    mirror,  ///< of the subject as a mirrored eye sees through it: `edge` is the subject's
    sum,     ///< of a sum of several shapes: named by its goal and part alone
  };
  Kind kind = Kind::domain;
  std::uint32_t goal = 0;
  std::uint32_t part = 0;
  std::optional<std::uint32_t> subject = {};  ///< vertex of the subject
  std::optional<std::uint32_t> edge = {};     ///< of the blocker's part
  std::optional<std::uint32_t> vertex = {};   ///< of the blocker's part, with an edge of the subject
};

enum class DesignStatus { feasible, flat, infeasible, sufficient_only };

constexpr std::string_view name(DesignStatus status) {
  constexpr std::string_view names[] = {"feasible", "flat", "infeasible", "sufficient_only"};
  return names[static_cast<int>(status)];
}

/// Which of all feasible positions is the answer.
enum class Choice {
  centre,     ///< of the largest ball: the farthest from every boundary
  cube,       ///< of the largest cube along the axes
  nearest,    ///< to a given point
  brightest,  ///< where the darkest corner of all subjects of irradiance, else of light, is brightest
};

/// A number that is off by at most its bound.
struct BoundedNumber {
  double value = 0;
  double error_bound = 0;
};

/// A position, and what can be said for it.
struct DesignAnswer {
  Point3 position;                   ///< rounded to the nearest doubles
  std::array<ExactNumber, 3> exact;  ///< before it was rounded
  double margin = 0;           ///< radius of a ball around `exact`, in the domain, that is feasible; a lower bound
  bool representable = false;  ///< the rounded position is feasible itself
};

/// What became of a goal at a position.
struct GoalOutcome {
  bool satisfied = false;
  std::string region;                ///< as exact_visibility says at the rounded position; empty if that is not asked
  std::optional<double> slack = {};  ///< signed distance from the nearest plane that matters, within the domain
  std::optional<DesignWall> wall = {};           ///< that plane
  std::optional<BoundedNumber> irradiance = {};  ///< of the darkest corner, for `irradiance`, where nothing hides it
  std::optional<BoundedNumber> exponent = {};    ///< Phong's, that the contour of a highlight asks for
};

/// Goals of which each is needed to leave nothing.
struct DesignConflict {
  std::vector<std::uint32_t> goals;
  std::vector<std::string> multipliers = {};  ///< Farkas': planes times these add up to a contradiction
  std::vector<DesignWall> planes = {};        ///< those planes
};

/// A convex piece of what is feasible.
struct FeasibleCell {
  std::vector<Point3> corners;                    ///< rounded
  std::vector<bool> at_infinity;                  ///< of each corner: a direction
  std::vector<std::vector<std::uint32_t>> faces;  ///< loops of corners; of flat cells one; of segments none
  std::vector<std::optional<DesignWall>> walls;   ///< of each face
};

struct DesignResult {
  DesignStatus status = DesignStatus::infeasible;
  std::optional<DesignAnswer> answer;
  std::vector<GoalOutcome> goals;
  std::vector<FeasibleCell> cells;
  bool bounded = true;
  int dimension = -1;
  ExactNumber size;  ///< volume, area or length; `exact` is empty where irrational, and for more than 8 solid cells
  std::optional<DesignConflict> conflict;
  std::vector<std::string> remarks;  ///< sentences for people
};

/// How a design is solved.
struct DesignEffort {
  Choice choice = Choice::centre;
  std::optional<Point3> near = {};  ///< of Choice::nearest
  std::size_t most_cells = 10000;
};

/// The task is understood, but cannot be solved; what() says what would have to be different.
class DesignError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Every position that fulfils all goals, as convex cells, and one of them.
///
/// Definition: the subject's dark cones and volumes are the shadows that lights there would cast (reciprocity), so
///             every wall is a plane through a subject's vertex and a blocker's edge, or an edge and a vertex. Goals
///             for polygons hold for almost every point of them. Dark polygons behind several blockers together are
///             told as `sufficient_only`: dark behind one of them each.
/// Returns:    cells without common interior, closed; boundaries that no position may lie on belong to them, but are no
///             answer. Of cells without interior (`flat`) those whose middle is feasible.
/// Exactness:  every decision is a sign of whole numbers; the answer is rational and rounded once.
/// Throws:     DesignError for more cells than asked for, unbounded choices, and shapes that are not supported.
DesignResult solved_design(const Design& design, const DesignObstacles& obstacles, const DesignEffort& effort);

/// The same for a given position alone: what becomes of each goal there. No cells are made.
DesignResult checked_design(const Design& design, const DesignObstacles& obstacles, const Point3& position);

/// Reads a goals file; names in it are those of the scene.
///
/// Throws: SceneError, UnsupportedSceneError.
Design read_design(const std::filesystem::path& file, const SpaceScene& scene);

/// The same from text. `source` names it in messages.
Design parse_design(std::string_view text, const std::string& source, const SpaceScene& scene);

}  // namespace gnomon
