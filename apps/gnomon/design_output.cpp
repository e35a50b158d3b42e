#include "apps/gnomon/design_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json wall_json(const DesignWall& wall, const SolvedDesign& solved) {
  Json json = Json::object();
  if (wall.kind == DesignWall::Kind::domain) {
    json["domain"] = wall.edge ? Json(*wall.edge) : Json(nullptr);
    return json;
  }
  json["goal"] = solved.design.goals[wall.goal].name;
  if (wall.kind == DesignWall::Kind::front) json["front"] = true;
  if (wall.kind == DesignWall::Kind::mirror) json["mirrored"] = true;
  if (wall.subject) json["subject"] = *wall.subject;
  const bool has_part = wall.kind == DesignWall::Kind::shadow || wall.kind == DesignWall::Kind::sum;
  if (has_part && wall.part < solved.obstacles.parts.size()) json["blocker"] = solved.obstacles.parts[wall.part];
  if (wall.edge) json["edge"] = *wall.edge;
  if (wall.vertex) json["vertex"] = *wall.vertex;
  return json;
}

std::string wall_text(const DesignWall& wall, const SolvedDesign& solved) {
  if (wall.kind == DesignWall::Kind::domain) return "the domain's side";
  if (wall.kind == DesignWall::Kind::front) return "the receiver's plane";
  if (wall.kind == DesignWall::Kind::mirror) {
    return wall.edge ? "the mirrored eye's view of edge " + std::to_string(*wall.edge) : "the receiver's plane";
  }
  std::string text = "blocker " + solved.obstacles.parts[wall.part];
  if (wall.edge) text += " edge " + std::to_string(*wall.edge);
  if (wall.vertex) text += " vertex " + std::to_string(*wall.vertex);
  if (wall.subject && wall.edge) text += ", the subject's vertex " + std::to_string(*wall.subject);
  if (wall.subject && !wall.edge) text += ", the subject's edge " + std::to_string(*wall.subject);
  return text;
}

Json coordinates_json(const Design& design, const Point3& p) {
  if (design.variable == FreeVariable::scale) return Json::array({p.x});
  return Json::array({p.x, p.y, p.z});
}

Json answer_json(const SolvedDesign& solved) {
  if (!solved.result.answer) return nullptr;
  const DesignAnswer& answer = *solved.result.answer;
  Json json;
  json["position"] = coordinates_json(solved.design, answer.position);
  json["exact"] = Json::array();
  const std::size_t count = solved.design.variable == FreeVariable::scale ? 1 : 3;
  for (std::size_t k = 0; k < count; ++k) json["exact"].push_back(answer.exact[k].exact);
  if (!solved.is_check) json["margin"] = answer.margin;
  json["representable"] = answer.representable;
  return json;
}

Json bounded_json(const BoundedNumber& number) {
  return {{"double", number.value}, {"error_bound", printed_error_bound(number.value, number.error_bound)}};
}

Json goals_json(const SolvedDesign& solved) {
  Json list = Json::array();
  for (std::size_t g = 0; g < solved.result.goals.size(); ++g) {
    const GoalOutcome& outcome = solved.result.goals[g];
    Json json = {{"name", solved.design.goals[g].name},
                 {"want", name(solved.design.goals[g].want)},
                 {"satisfied", outcome.satisfied}};
    if (!outcome.region.empty()) json["region"] = outcome.region;
    if (outcome.slack) json["slack"] = {{"double", *outcome.slack}};
    if (outcome.wall) json["plane"] = wall_json(*outcome.wall, solved);
    if (outcome.irradiance) json["irradiance"] = bounded_json(*outcome.irradiance);
    if (outcome.exponent) json["exponent"] = bounded_json(*outcome.exponent);
    list.push_back(std::move(json));
  }
  return list;
}

Json region_json(const SolvedDesign& solved) {
  if (solved.is_check) return nullptr;
  const DesignResult& result = solved.result;
  Json json = {{"cells", result.cells.size()}, {"bounded", result.bounded}};
  json["dimension"] = result.dimension < 0 ? Json(nullptr) : Json(result.dimension);
  const bool has_size = result.bounded && !result.cells.empty() && solved.design.variable != FreeVariable::direction;
  json["size"] = nullptr;
  if (!has_size) return json;
  json["size"] = {{"double", result.size.nearest}};
  if (!result.size.exact.empty()) json["size"]["exact"] = result.size.exact;
  return json;
}

Json conflict_json(const SolvedDesign& solved) {
  if (!solved.result.conflict) return nullptr;
  const DesignConflict& conflict = *solved.result.conflict;
  Json json;
  json["goals"] = Json::array();
  for (const std::uint32_t g : conflict.goals) json["goals"].push_back(solved.design.goals[g].name);
  json["minimal"] = true;
  json["multipliers"] = nullptr;
  if (conflict.multipliers.empty()) return json;
  json["multipliers"] = conflict.multipliers;
  json["planes"] = Json::array();
  for (const DesignWall& wall : conflict.planes) json["planes"].push_back(wall_json(wall, solved));
  return json;
}

std::string variable_word(FreeVariable variable) {
  const bool is_shift = variable == FreeVariable::translation || variable == FreeVariable::blocker;
  return is_shift ? "shift" : std::string(name(variable));
}

DrawnWall drawn_wall(const std::vector<std::uint32_t>& corners, const std::optional<DesignWall>& wall) {
  constexpr std::int32_t goal_plane = 6, domain = 7;
  DrawnWall drawn{corners};
  if (!wall || wall->kind == DesignWall::Kind::domain) {
    drawn.facet_kind = domain;
    return drawn;
  }
  drawn.facet_kind = goal_plane;
  drawn.goal = static_cast<std::int32_t>(wall->goal);
  if (wall->edge) drawn.edge = static_cast<std::int32_t>(*wall->edge);
  if (wall->vertex) drawn.vertex = static_cast<std::int32_t>(*wall->vertex);
  if (wall->subject && wall->edge) drawn.vertex = static_cast<std::int32_t>(*wall->subject);
  if (wall->subject && !wall->edge) drawn.edge = static_cast<std::int32_t>(*wall->subject);
  return drawn;
}

std::string size_name(int dimension) {
  return dimension == 3 ? "volume" : dimension == 2 ? "area" : "length";
}

std::string region_text(const SolvedDesign& solved) {
  const DesignResult& result = solved.result;
  if (result.cells.empty()) return "nothing";
  std::string text = counted(result.cells.size(), "convex cell") + " of dimension " + std::to_string(result.dimension);
  if (!result.bounded) return text + ", unbounded";
  if (solved.design.variable == FreeVariable::direction || result.dimension == 0) return text;
  text += ", " + size_name(result.dimension) + ' ' + rounded_text(result.size.nearest);
  return result.size.exact.empty() ? text : text + " (exactly " + result.size.exact + ")";
}

std::string conflict_text(const SolvedDesign& solved) {
  const DesignConflict& conflict = *solved.result.conflict;
  std::string text;
  for (const std::uint32_t g : conflict.goals) text += (text.empty() ? "" : ", ") + solved.design.goals[g].name;
  if (text.empty()) return "the domain alone leaves nothing";
  text += conflict.goals.size() == 1 ? " cannot be fulfilled in the domain"
                                     : " collide; without any one of them the rest can be fulfilled";
  return text;
}

std::string goals_text(const SolvedDesign& solved) {
  std::vector<TextRow> rows;
  for (std::size_t g = 0; g < solved.result.goals.size(); ++g) {
    const DesignGoal& goal = solved.design.goals[g];
    const GoalOutcome& outcome = solved.result.goals[g];
    const std::string seen = outcome.region.empty() ? "" : " (" + outcome.region + ")";
    const std::string slack = outcome.slack ? rounded_text(*outcome.slack) : "";
    std::string from = outcome.wall ? "from " + wall_text(*outcome.wall, solved) : "";
    if (outcome.irradiance) from += "; irradiance at least " + rounded_text(outcome.irradiance->value) + " W/m^2";
    if (outcome.exponent) from += "; Phong's exponent " + rounded_text(outcome.exponent->value);
    rows.push_back({goal.name, std::string(name(goal.want)), (outcome.satisfied ? "yes" : "NO") + seen, slack, from});
  }
  return aligned(rows, 2);
}

}  // namespace

DrawnDesign drawn_design(const SolvedDesign& solved, std::size_t& left_out) {
  DrawnDesign drawn;
  drawn.status = name(solved.result.status);
  left_out = 0;
  for (const FeasibleCell& cell : solved.result.cells) {
    if (std::ranges::find(cell.at_infinity, true) != cell.at_infinity.end()) {
      ++left_out;
      continue;
    }
    DrawnCell& shape = drawn.cells.emplace_back(DrawnCell{cell.corners, {}});
    for (std::size_t f = 0; f < cell.faces.size(); ++f) shape.walls.push_back(drawn_wall(cell.faces[f], cell.walls[f]));
  }
  for (std::size_t g = 0; g < solved.design.goals.size(); ++g) {
    DrawnGoal& goal = drawn.goals.emplace_back(DrawnGoal{solved.design.goals[g].name, {}});
    for (const DesignSubject& subject : solved.design.goals[g].subjects) goal.subjects.push_back(subject.points);
    if (!solved.result.goals.empty()) goal.status = solved.result.goals[g].satisfied ? 0 : 1;
  }
  if (!solved.result.answer) return drawn;
  drawn.answer = solved.result.answer->position;
  if (solved.design.variable != FreeVariable::direction) drawn.margin = solved.result.answer->margin;
  return drawn;
}

std::string position_text(const Design& design, const Point3& p) {
  if (design.variable == FreeVariable::scale) return number_text(p.x);
  return number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z);
}

Json design_json(const SolvedDesign& solved) {
  const Design& design = solved.design;
  const bool is_blocker = design.variable == FreeVariable::blocker;
  Json json = {
      {"schema", "gnomon/place/1"},
      {"scene", solved.scene.source},
      {"length_unit", solved.scene.length_unit},
      {"variable", {{is_blocker ? "blocker" : "light", design.variable_name}, {"free", name(design.variable)}}},
      {"checked", solved.is_check},
      {"status", name(solved.result.status)}};
  json["answer"] = answer_json(solved);
  json["goals"] = goals_json(solved);
  json["region"] = region_json(solved);
  json["conflict"] = conflict_json(solved);
  json["remarks"] = solved.result.remarks;
  return json;
}

std::string design_text(const SolvedDesign& solved) {
  const DesignResult& result = solved.result;
  std::string text;
  const std::string status = std::string(name(result.status));
  if (!solved.is_check) {
    text += labelled("status", status);
    text += labelled("region", region_text(solved));
  } else {
    text += labelled(
        "status", result.status == DesignStatus::feasible ? "every goal is fulfilled" : "not every goal is fulfilled");
  }
  if (result.answer) {
    std::string line = position_text(solved.design, result.answer->position);
    if (!solved.is_check) {
      line += ", at least " + rounded_text(result.answer->margin) + " from every boundary";
      if (!result.answer->representable) {
        line += "; rounded to doubles it is no answer: exactly " + result.answer->exact[0].exact + ", " +
                result.answer->exact[1].exact + ", " + result.answer->exact[2].exact;
      }
    }
    text += labelled(variable_word(solved.design.variable), line);
  }
  if (!result.goals.empty())
    text += "goals, whether they are fulfilled, and how far from failing:\n" + goals_text(solved);
  if (result.conflict) text += labelled("conflict", conflict_text(solved));
  if (result.status == DesignStatus::sufficient_only) {
    text += labelled("note",
                     "receivers may be dark behind several blockers together: there may be more positions than these");
  }
  for (const std::string& remark : result.remarks) text += labelled("note", remark);
  return text;
}

}  // namespace gnomon
