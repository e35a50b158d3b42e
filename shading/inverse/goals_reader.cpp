#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/bodies/body.h"
#include "geometry/numbers/orientation.h"
#include "geometry/scene/file_text.h"
#include "geometry/scene/json_node.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/scene_elements.h"
#include "gnomon/light_design.h"
#include "shading/inverse/domain_reader.h"
#include "shading/inverse/goal_sets.h"

namespace gnomon {
namespace inverse {
namespace {

constexpr std::size_t largest_goals_file = std::size_t{16} << 20;

std::string names_text(std::vector<std::string> names) {
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k) text += (k ? ", " : "") + in_quotes(names[k]);
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return names.empty() ? "none" : text;
}

template <class Elements>
std::vector<std::string> names_of(const Elements& elements) {
  std::vector<std::string> names;
  for (const auto& element : elements) names.push_back(element.name);
  return names;
}

bool is_one_of(const std::string& word, const std::vector<std::string>& words) {
  return std::ranges::find(words, word) != words.end();
}

const SceneLight& named_light(const JsonNode& node, const SpaceScene& scene) {
  const std::string expected = "the name of a light of the scene among " + names_text(names_of(scene.lights));
  const std::string name = node.string(expected);
  const auto found = std::ranges::find(scene.lights, name, &SceneLight::name);
  if (found == scene.lights.end()) node.refuse_value(expected);
  return *found;
}

/// The name of a blocker or of one of its parts.
std::string named_blocker(const JsonNode& node, const DesignObstacles& obstacles) {
  std::vector<std::string> known = obstacles.elements;
  known.insert(known.end(), obstacles.parts.begin(), obstacles.parts.end());
  const std::string expected = "the name of a blocker of the scene, or of a part of one, among " + names_text(known);
  const std::string name = node.string(expected);
  if (!is_one_of(name, known)) node.refuse_value(expected);
  return name;
}

/// Reads one goals file beside its scene.
class GoalsReader {
 public:
  GoalsReader(const JsonNode& document, const SpaceScene& scene)
      : document_(document), scene_(scene), obstacles_(design_obstacles(scene)) {}

  Design design() {
    document_.require_object("an object with the keys \"gnomon_goals\", \"variable\", \"goals\"");
    document_.allow_keys({"$schema", "gnomon_goals", "variable", "domain", "goals", "margin"}, "a goals file");
    const JsonNode version = document_.required("gnomon_goals", "the version of the format, 1");
    if (!version.is_number(1)) version.refuse_value("the version of the format, 1");
    read_variable(document_.required("variable", "what is sought: an object with \"light\" or \"blocker\""));
    read_domain_of_variable();
    constexpr const char* goals = "an array of goals";
    for (const JsonNode& node : document_.required("goals", goals).items(goals)) read_goal(node);
    if (const auto node = document_.optional("margin")) {
      design_.margin = finite(*node, "a distance of at least 0");
      if (design_.margin < 0) node->refuse_value("a distance of at least 0");
      if (design_.margin > 0 && design_.variable == FreeVariable::direction) {
        node->refuse_as_unsupported("a margin of directions", "0, or another variable");
      }
    }
    return design_;
  }

 private:
  void read_variable(const JsonNode& node) {
    node.require_object("an object with \"light\" or \"blocker\"");
    node.allow_keys({"light", "blocker", "free", "centre"}, "a variable");
    const auto light = node.optional("light"), blocker = node.optional("blocker");
    if (light && blocker) blocker->refuse("a light and a blocker", "one variable");
    if (blocker) return read_moved_blocker(node, *blocker);
    const SceneLight& chosen =
        named_light(node.required("light", "the name of the light that is sought, or \"blocker\""), scene_);
    design_.light = chosen.shape;
    design_.variable_name = chosen.name;
    const LengthUnit unit = length_unit_named(scene_.length_unit).value();
    const double metres = unit.top / unit.bottom;
    design_.intensity = chosen.strength / (metres * metres);
    if (chosen.is_part()) node.refuse_as_unsupported("a light of several parts", "a light of one convex shape");
    constexpr const char* words = "\"position\", \"direction\", \"translation\" or \"scale\"";
    const JsonNode free = node.required("free", words);
    read_freedom(free, free.string(words), words);
    if (const auto centre = node.optional("centre")) {
      if (design_.variable != FreeVariable::scale) centre->refuse("a centre", "none, but with \"free\": \"scale\"");
      design_.centre = point3(*centre);
    }
  }

  void read_freedom(const JsonNode& node, const std::string& word, const char* words) {
    const bool is_point = std::holds_alternative<PointLight>(design_.light);
    const bool is_sun = std::holds_alternative<DirectionalLight>(design_.light);
    if (word == "position") {
      if (!is_point)
        node.refuse("\"position\" of a light with a size or without a place",
                    "\"position\" of a point light, \"translation\", or \"direction\" of a directional one");
    } else if (word == "direction") {
      if (!is_sun) node.refuse("\"direction\" of a light that has a place", "\"direction\" of a directional light");
      design_.variable = FreeVariable::direction;
    } else if (word == "translation") {
      if (is_sun) node.refuse("\"translation\" of a directional light", "\"direction\"");
      design_.variable = FreeVariable::translation;
    } else if (word == "scale") {
      if (is_sun || is_point) node.refuse("\"scale\" of a light without a size", "a segment or a polygon");
      design_.variable = FreeVariable::scale;
    } else if (word == "rotation") {
      node.refuse_as_unsupported("\"rotation\": a light is not turned", words);
    } else {
      node.refuse_value(words);
    }
  }

  void read_moved_blocker(const JsonNode& node, const JsonNode& blocker) {
    design_.variable = FreeVariable::blocker;
    const std::string expected = "the name of a blocker among " + names_text(obstacles_.elements);
    design_.blocker = blocker.string(expected);
    design_.variable_name = design_.blocker;
    if (!is_one_of(design_.blocker, obstacles_.elements)) blocker.refuse_value(expected);
    if (const auto free = node.optional("free")) {
      if (free->string("\"translation\"") != "translation") free->refuse_value("\"translation\"");
    }
  }

  void read_domain_of_variable() {
    const auto node = document_.optional("domain");
    if (node) design_.domain = read_domain(*node);
    const bool is_cone = design_.domain.shape == DomainShape::directions;
    const bool is_interval = node && node->required("shape", "a shape").string("a shape") == "interval";
    if ((design_.variable == FreeVariable::scale) != is_interval) {
      node.value_or(document_).refuse(
          is_interval ? "an interval" : "no interval of scales",
          is_interval ? "a domain of positions"
                      : "\"domain\": {\"shape\": \"interval\", \"min\": ..., \"max\": ...}, because a scale is sought");
    }
    if (design_.variable == FreeVariable::direction) {
      if (!node) design_.domain.shape = DomainShape::directions;
      if (node && !is_cone) node->refuse("a domain of positions", "\"directions\", because a direction is sought");
    } else if (is_cone) {
      node->refuse("a domain of directions", "one of positions");
    }
  }

  Want want(const JsonNode& node) {
    constexpr const char* words =
        "\"lit\", \"shadow\", \"dark\", \"penumbra\", \"edge\", \"nail\", \"no_reflection\", \"not_seen_from\", "
        "\"irradiance\", \"diffuse_peak\" or \"highlight\"";
    const std::string word = node.string(words);
    for (int k = 0; k <= static_cast<int>(Want::highlight); ++k) {
      if (name(static_cast<Want>(k)) == word) return static_cast<Want>(k);
    }
    node.refuse_value(words);
  }

  void read_goal(const JsonNode& given) {
    given.require_object("a goal: an object with \"name\", \"want\" and \"at\" or \"on\"");
    DesignGoal goal;
    const JsonNode name_node = given.required("name", "a name of its own");
    goal.name = name_node.string("a name of its own");
    for (const DesignGoal& other : design_.goals) {
      if (other.name == goal.name) name_node.refuse("the name " + in_quotes(goal.name) + " again", "a name of its own");
    }
    const JsonNode node = given.as_element("goal " + in_quotes(goal.name));
    node.allow_keys({"name", "at", "on", "normal", "want", "by", "edge", "vertex", "eye", "light", "at_least",
                     "contour", "whole", "threshold"},
                    "a goal");
    goal.want = want(node.required("want", "what is wanted"));
    read_subjects(node, goal);
    if (const auto by = node.optional("by")) goal.by = named_blocker(*by, obstacles_);
    read_element(node, goal);
    read_eye(node, goal);
    read_goal_light(node, goal);
    read_whole(node);
    check_kind(node, goal);
    read_brightness(node, goal);
    read_peak(node, goal);
    design_.goals.push_back(std::move(goal));
  }

  void read_subjects(const JsonNode& node, DesignGoal& goal) {
    const auto at = node.optional("at"), on = node.optional("on"), normal = node.optional("normal");
    if (!at == !on)
      node.refuse(at ? "\"at\" and \"on\"" : "neither \"at\" nor \"on\"",
                  "a point \"at\", or the name of a receiver that the goal is \"on\"");
    if (at) {
      DesignSubject subject{{point3(*at)}, {}};
      if (normal) {
        const Point3 n = point3(*normal);
        if (n == Point3{}) normal->refuse("the zero vector", "a normal");
        subject.front = FacingNormal{n};
      }
      goal.subjects.push_back(std::move(subject));
      return;
    }
    if (normal) normal->refuse("a normal beside \"on\"", "none: a receiver has its own");
    std::vector<std::string> known;
    for (const SceneReceiver& receiver : scene_.receivers) known.push_back(receiver.side);
    const std::string expected = "the name of a receiver of the scene among " + names_text(known);
    const std::string asked = on->string(expected);
    for (const SceneReceiver& receiver : scene_.receivers) {
      if (!receiver.is_called(asked)) continue;
      if (!receiver.shape.is_flat())
        on->refuse_as_unsupported("a receiver whose vertices are not exactly in one plane", "a flat receiver");
      const auto corners = receiver.shape.corners();
      DesignSubject subject;
      for (const std::uint32_t k : corners) subject.points.push_back(receiver.shape.points()[k]);
      subject.front = FacetFront{{subject.points[0], subject.points[1], subject.points[2]}};
      goal.subjects.push_back(std::move(subject));
    }
    if (goal.subjects.empty()) on->refuse_value(expected);
  }

  void read_element(const JsonNode& node, DesignGoal& goal) {
    const auto edge = node.optional("edge"), vertex = node.optional("vertex");
    if (edge && goal.want != Want::edge) edge->refuse("an edge", "none, but with \"want\": \"edge\"");
    if (vertex && goal.want != Want::nail) vertex->refuse("a vertex", "none, but with \"want\": \"nail\"");
    if (goal.want != Want::edge && goal.want != Want::nail) return;
    const JsonNode by = node.required("by", "the blocker whose edge or vertex is meant");
    const std::vector<std::uint32_t> parts = parts_that_count(goal, obstacles_);
    if (parts.size() != 1)
      by.refuse_as_unsupported("a blocker of several parts",
                               "one part, such as " + in_quotes(obstacles_.parts[parts[0]]));
    const ConvexBlocker& blocker = obstacles_.obstacles.blockers[parts[0]];
    const bool is_edge = goal.want == Want::edge;
    const auto* solid = std::get_if<ConvexSolid>(&blocker);
    const std::size_t count = is_edge && solid ? solid->edges().size() : points_of(blocker).size();
    const std::string expected = "a whole number from 0 to " + std::to_string(count - 1);
    const JsonNode index = node.required(is_edge ? "edge" : "vertex", expected);
    const double number = index.number(expected);
    if (!(number >= 0) || number >= static_cast<double>(count) || number != std::floor(number))
      index.refuse_value(expected);
    goal.element = static_cast<std::uint32_t>(number);
  }

  void read_eye(const JsonNode& node, DesignGoal& goal) {
    const auto eye = node.optional("eye");
    const bool has_eye = goal.want == Want::no_reflection || goal.want == Want::highlight;
    if (eye && !has_eye) eye->refuse("an eye", "none, but with \"want\": \"no_reflection\" or \"highlight\"");
    if (!has_eye) return;
    const JsonNode needed = node.required("eye", "where the eye is: three coordinates");
    goal.eye = point3(needed);
    if (goal.want == Want::no_reflection && goal.subjects[0].points.size() < 3)
      node.refuse("a point", "a flat receiver that the goal is \"on\"");
    for (const DesignSubject& subject : goal.subjects) {
      if (subject.front && value(front_plane(subject), whole_point(goal.eye)) >= 0) {
        needed.refuse("an eye behind the receiver, or in its plane", "an eye before it");
      }
    }
  }

  void read_goal_light(const JsonNode& node, DesignGoal& goal) {
    const auto light = node.optional("light");
    if (design_.variable != FreeVariable::blocker) {
      if (light && light->string("a light's name") != design_.variable_name)
        light->refuse_as_unsupported(light->description(), "the light that is sought");
      return;
    }
    goal.light =
        named_light(node.required("light", "the light whose shadow is meant, because a blocker is moved"), scene_)
            .shape;
  }

  void read_brightness(const JsonNode& node, DesignGoal& goal) {
    const auto at_least = node.optional("at_least");
    if (at_least && goal.want != Want::irradiance)
      at_least->refuse("at_least", "none, but with \"want\": \"irradiance\"");
    if (goal.want != Want::irradiance) return;
    const JsonNode want = node.required("want", "what is wanted");
    if (design_.variable != FreeVariable::position) {
      want.refuse_as_unsupported("\"irradiance\" where no position of a point light is sought",
                                 "a point light's position");
    }
    if (!goal.subjects[0].front)
      want.refuse("\"irradiance\" at a point without a normal", "a \"normal\", or a receiver");
    if (!goal.by.empty())
      node.required("by", "nothing").refuse("a blocker", "none: all count where irradiance is wanted");
    constexpr const char* expected = "an irradiance above 0, in W/m^2";
    const JsonNode number = node.required("at_least", expected);
    const double wanted = finite(number, expected);
    if (!(wanted > 0)) number.refuse_value(expected);
    goal.at_least = wanted / design_.intensity;
    if (!std::isfinite(goal.at_least) || goal.at_least == 0) {
      number.refuse("an irradiance that this light does not give anywhere", expected);
    }
  }

  void read_peak(const JsonNode& node, DesignGoal& goal) {
    const auto contour = node.optional("contour"), threshold = node.optional("threshold");
    const bool is_highlight = goal.want == Want::highlight;
    if (contour && !is_highlight) contour->refuse("a contour", "none, but with \"want\": \"highlight\"");
    if (threshold && !contour) threshold->refuse("a threshold without a \"contour\"", "both or none");
    if (contour) goal.contour = point3(*contour);
    if (threshold) {
      goal.threshold = finite(*threshold, "a number between 0 and 1");
      if (!(goal.threshold > 0 && goal.threshold < 1)) threshold->refuse_value("a number between 0 and 1");
    }
    if (!is_highlight && goal.want != Want::diffuse_peak) return;
    const JsonNode want = node.required("want", "what is wanted");
    const bool is_point = goal.subjects[0].points.size() == 1 && goal.subjects[0].front;
    if (!is_point) want.refuse(want.description() + " without a point and its normal", "\"at\" with a \"normal\"");
    if (design_.variable != FreeVariable::position && design_.variable != FreeVariable::direction) {
      want.refuse_as_unsupported(want.description() + " where a light or blocker is moved",
                                 "a point light's position or a direction");
    }
  }

  /// Lights with a size stand before a receiver whole.
  static void read_whole(const JsonNode& node) {
    const auto whole = node.optional("whole");
    if (whole && !whole->boolean("true"))
      whole->refuse_as_unsupported("a light that stands before a receiver in part", "true");
  }

  void check_kind(const JsonNode& node, const DesignGoal& goal) {
    const JsonNode want = node.required("want", "what is wanted");
    const bool is_point = goal.subjects[0].points.size() == 1;
    const bool has_size = design_.variable != FreeVariable::position && design_.variable != FreeVariable::direction;
    if (goal.want == Want::penumbra && !has_size)
      want.refuse("\"penumbra\" of a light without a size", "\"lit\" or \"dark\"");
    const bool needs_point = goal.want == Want::edge || goal.want == Want::nail || goal.want == Want::not_seen_from;
    if (needs_point && !is_point)
      want.refuse(want.description() + " on a receiver", "a point \"at\" which it is wanted");
    const bool needs_position = goal.want == Want::edge || goal.want == Want::nail || goal.want == Want::no_reflection;
    if (needs_position && has_size)
      want.refuse_as_unsupported(want.description() + " where a light or blocker is moved",
                                 "a point light's position or a direction");
  }

  const JsonNode& document_;
  const SpaceScene& scene_;
  DesignObstacles obstacles_;
  Design design_;
};

}  // namespace
}  // namespace inverse

Design parse_design(std::string_view text, const std::string& source, const SpaceScene& scene) {
  const nlohmann::json document = parse_json(text, source);
  return inverse::GoalsReader(JsonNode(document, source), scene).design();
}

Design read_design(const std::filesystem::path& file, const SpaceScene& scene) {
  const FileText text = file_text(file, inverse::largest_goals_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected a goals file");
  return parse_design(text.text, file.string(), scene);
}

}  // namespace gnomon
