#include "apps/proof/theorems_output.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "apps/gnomon/scene_text.h"
#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t statement_width = 72;

/// The text in lines of at most so many characters, where its words allow it.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

std::string fixed(double value, int digits) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

std::string status_text(const LawTrial& trial) {
  switch (trial.status) {
    case LawStatus::holds:
      return "holds";
    case LawStatus::refuted:
      return "refuted";
    case LawStatus::counterexample:
      return "COUNTEREXAMPLE FOUND";
    default:
      return "NO LONGER REFUTED";
  }
}

void add_rows(std::vector<TextRow>& rows, const LawTrial& trial) {
  const laws::Outcome& outcome = trial.outcome;
  const auto lines = wrapped(trial.law.statement + " (" + trial.law.source + ")", statement_width);
  rows.push_back({trial.law.key, lines.front(), std::to_string(outcome.premise_held),
                  fixed(100 * outcome.premise_share(), 0) + " %", status_text(trial), fixed(trial.seconds, 2)});
  for (std::size_t i = 1; i < lines.size(); ++i) rows.push_back({"", lines[i]});
}

bool is_counted(std::span<const std::uint32_t> counts) {
  return std::ranges::any_of(counts, [](std::uint32_t count) { return count > 0; });
}

void add_counts(TextRow& row, std::span<const std::uint32_t> counts) {
  const bool counted = is_counted(counts);
  for (const std::uint32_t count : counts) row.push_back(counted ? std::to_string(count) : "-");
}

std::string indented(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) result += "  " + line + '\n';
  return result;
}

/// The document's counts of one kind; nothing where none were made.
void add_json(Json& json, const char* key, std::span<const std::uint32_t> counts) {
  if (is_counted(counts)) json[key] = Json(std::vector<std::uint32_t>(counts.begin(), counts.end()));
}

Json census_json(const laws::Census& census) {
  Json json{{"cases", census.cases}};
  add_json(json, "points", census.points);
  add_json(json, "umbrae", census.umbrae);
  add_json(json, "penumbrae", census.penumbrae);
  add_json(json, "pockets", census.pockets);
  return json;
}

std::string command_to_see(const LawTrial& trial, const TrialOptions& options) {
  return "gnomon theorems --only " + trial.law.key + " --seed " + std::to_string(options.seed) + " --cases " +
         std::to_string(trial.cases_to_failure) + (options.mutant.empty() ? "" : " --mutant " + options.mutant);
}

Json example_json(const LawTrial& trial, const TrialOptions& options) {
  const bool failed = trial.outcome.counterexample.has_value();
  Json json{{"text", failed ? *trial.outcome.counterexample : trial.known.refutation.value_or("")}};
  if (failed) json["command"] = command_to_see(trial, options);
  if (const auto& example = shown_example(trial)) {
    json["scene"] = scene_document(example->scene);
    json["points"] = Json::array();
    for (const Point3& p : example->points) json["points"].push_back({p.x, p.y, p.z});
  }
  return json;
}

Json trial_json(const LawTrial& trial, const TrialOptions& options) {
  const laws::Outcome& outcome = trial.outcome;
  Json json{{"key", trial.law.key},
            {"source", trial.law.source},
            {"statement", trial.law.statement},
            {"status", name(trial.status)},
            {"cases", outcome.premise_held},
            {"drawn", outcome.cases},
            {"premise_share", outcome.premise_share()}};
  if (trial.law.standing == laws::Standing::refuted) json["refuting"] = outcome.refuting;
  json["seconds"] = trial.seconds;
  if (outcome.census.cases > 0) json["regions"] = census_json(outcome.census);
  if (trial.status != LawStatus::holds) json["counterexample"] = example_json(trial, options);
  return json;
}

}  // namespace

std::string trials_table(const std::vector<LawTrial>& trials) {
  std::vector<TextRow> rows{{"key", "statement", "cases", "premise", "status", "seconds"}};
  for (const LawTrial& trial : trials) add_rows(rows, trial);
  return aligned(rows, 0);
}

std::string census_table(const std::vector<LawTrial>& trials) {
  std::vector<TextRow> rows{
      {"", "counted", "point", "", "", "", "umbrae", "", "", "penumbrae", "", "", "", "pockets", "", ""},
      {"key", "cases", "lit", "penumbra", "umbra", "unlit", "0", "1", "2+", "0", "1", "2", "3+", "0", "1", "2+"}};
  for (const LawTrial& trial : trials) {
    const laws::Census& census = trial.outcome.census;
    if (census.cases == 0) continue;
    TextRow row{trial.law.key, std::to_string(census.cases)};
    add_counts(row, census.points);
    add_counts(row, census.umbrae);
    add_counts(row, census.penumbrae);
    add_counts(row, census.pockets);
    rows.push_back(std::move(row));
  }
  return rows.size() == 2 ? "" : aligned(rows, 0);
}

const std::optional<laws::Example>& shown_example(const LawTrial& trial) {
  return trial.outcome.counterexample ? trial.outcome.example : trial.known.example;
}

std::string counterexample_text(const LawTrial& trial, const TrialOptions& options) {
  const std::string start = trial.law.key + ", " + trial.law.source + ": ";
  if (trial.outcome.counterexample) {
    return start + "counterexample found\n" + indented(*trial.outcome.counterexample) +
           "  again: " + command_to_see(trial, options) + '\n';
  }
  if (trial.status == LawStatus::not_refuted) return start + "the known counterexample does not refute the claim\n";
  return start + "refuted, and by " + std::to_string(trial.outcome.refuting) + " of " +
         std::to_string(trial.outcome.premise_held) + " cases drawn\n" + indented(*trial.known.refutation);
}

Json trials_json(const std::vector<LawTrial>& trials, const TrialOptions& options) {
  Json document{{"schema", "gnomon/theorems/1"}, {"seed", options.seed}, {"statements", Json::array()}};
  for (const LawTrial& trial : trials) document["statements"].push_back(trial_json(trial, options));
  return document;
}

}  // namespace gnomon
