#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "gnomon/paint_fit.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

struct FitOptions : CommonOptions {
  std::string paint;
};

void add_options(CommandLine& app, FitOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(app, "--paint", options.paint, "FILE", "Paint file: what is fitted, and samples");
  add_json_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Samples tell how bright points are wanted. Fitted are the intensities of lights to irradiance, none below 0, "
      "or\n"
      "a material (ambient, diffuse, specular from 0 to 1, and its exponent) to radiance seen by eyes: least squares,\n"
      "or bounds that all have to hold, the least ambient part first, then the largest diffuse one. What is visible "
      "is\n"
      "exact; the best values are found in rational numbers. Values that the samples leave open are told.\n"
      "Values and residuals are estimates: the columns that they rest on are rounded.\n\n"
      "Examples:\n"
      "  gnomon fit examples/two_lamps.scene.json --paint examples/lamps.paint.json\n"
      "  gnomon fit examples/two_lamps.scene.json --paint examples/floor.paint.json\n");
}

std::vector<std::string> unknowns_of(const Paint& paint) {
  if (paint.fit == Paint::Fit::intensities) return paint.lights;
  return {"ambient", "diffuse", "specular"};
}

/// One number, or one for each channel.
template <class Number>
Json by_channel(const PaintFit& fit, const Number& number) {
  if (fit.channels.size() == 1) return number(fit.channels[0]);
  Json list = Json::array();
  for (const LinearFit& channel : fit.channels) list.push_back(number(channel));
  return list;
}

bool is_feasible(const PaintFit& fit) {
  return std::ranges::all_of(fit.channels, &LinearFit::is_feasible);
}

/// Undetermined unknowns of any channel.
std::vector<std::string> undetermined(const PaintFit& fit, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (std::uint32_t k = 0; k < names.size(); ++k) {
    const auto is_open = [&](const LinearFit& channel) {
      return std::ranges::find(channel.undetermined, k) != channel.undetermined.end();
    };
    if (std::ranges::any_of(fit.channels, is_open)) found.push_back(names[k]);
  }
  return found;
}

/// Samples that exclude each other in the first channel that has such.
std::vector<std::uint32_t> conflict_of(const PaintFit& fit) {
  const auto found = std::ranges::find(fit.channels, false, &LinearFit::is_feasible);
  return found == fit.channels.end() ? std::vector<std::uint32_t>{} : found->conflict;
}

Json fit_json(const Paint& paint, const PaintFit& fit, const SpaceScene& scene) {
  const std::vector<std::string> names = unknowns_of(paint);
  const bool is_material = paint.fit == Paint::Fit::material;
  Json json = {{"schema", "gnomon/fit/1"},
               {"scene", scene.source},
               {"fit", is_material ? "material" : "intensities"},
               {"feasible", is_feasible(fit)}};
  json["values_are"] = "estimate";
  json["values"] = nullptr;
  json["residuals"] = nullptr;
  if (is_feasible(fit)) {
    json["values"] = Json::object();
    for (std::size_t k = 0; k < names.size(); ++k) {
      json["values"][names[k]] = by_channel(fit, [&](const LinearFit& channel) { return Json(channel.values[k]); });
    }
    json["residuals"] = Json::array();
    for (std::size_t s = 0; s < paint.samples.size(); ++s) {
      json["residuals"].push_back(
          by_channel(fit, [&](const LinearFit& channel) { return Json(channel.residuals[s]); }));
    }
  }
  json["rank"] = by_channel(fit, [](const LinearFit& channel) { return Json(channel.rank); });
  json["ill_conditioned"] = std::ranges::any_of(fit.channels, &LinearFit::ill_conditioned);
  json["undetermined"] = undetermined(fit, names);
  json["conflict"] = is_feasible(fit) ? Json(nullptr) : Json(conflict_of(fit));
  if (is_material) {
    json["exponent"] = fit.exponent;
    json["exponents_as_good"] = {fit.least_exponent, fit.most_exponent};
  }
  return json;
}

double largest_residual(const PaintFit& fit) {
  double most = 0;
  for (const LinearFit& channel : fit.channels) {
    for (const double r : channel.residuals) most = std::max(most, std::fabs(r));
  }
  return most;
}

std::string fit_text(const Paint& paint, const PaintFit& fit) {
  const std::vector<std::string> names = unknowns_of(paint);
  std::string text;
  if (!is_feasible(fit)) {
    for (const std::uint32_t s : conflict_of(fit)) text += (text.empty() ? "" : ", ") + std::to_string(s);
    return labelled("conflict", "no material lies within the bounds of samples " + text + " together");
  }
  std::vector<TextRow> rows;
  for (std::size_t k = 0; k < names.size(); ++k) {
    TextRow row = {names[k]};
    for (const LinearFit& channel : fit.channels) row.push_back(rounded_text(channel.values[k]));
    rows.push_back(std::move(row));
  }
  text = aligned(rows, 0);
  if (paint.fit == Paint::Fit::material) {
    std::string line = std::to_string(fit.exponent);
    if (fit.least_exponent != fit.most_exponent) {
      line +=
          "; as good are some from " + std::to_string(fit.least_exponent) + " to " + std::to_string(fit.most_exponent);
    }
    text += labelled("exponent", line);
  }
  text += labelled("residual", "at most " + rounded_text(largest_residual(fit)));
  const std::vector<std::string> open = undetermined(fit, names);
  std::string list;
  for (const std::string& name : open) list += (list.empty() ? "" : ", ") + name;
  if (!open.empty()) text += labelled("note", "the samples hardly tell " + list + " from the others");
  return text;
}

}  // namespace

ExitCode fit_command(Arguments arguments) {
  CommandLine app("Fits intensities of lights, or a material, to how bright points are wanted.", "gnomon fit");
  FitOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_place("--json", options.json, OutputKind::json);
  require_unread("--json", options.json, {options.scene, options.paint});
  const SpaceScene scene = space_scene_with_warnings(options.scene, "fitting");
  const Paint paint = read_paint(options.paint, scene);
  const PaintFit fit = fitted(paint, scene);
  if (!options.json.empty()) write_json(fit_json(paint, fit, scene), options.json);
  if (!options.quiet && options.json != "-") std::cout << fit_text(paint, fit);
  return ExitCode::done;
}

}  // namespace gnomon
