#include "apps/gnomon/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <numeric>
#include <optional>
#include <utility>

#include "apps/gnomon/text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

/// Number of letters to insert, delete or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

/// xmin,ymin,zmin,xmax,ymax,zmax, or xmin,ymin,xmax,ymax in the plane, where z runs from 0 to 0.
Box3 box_from_text(std::string_view text, std::size_t dimension) {
  const std::string start = "--box " + std::string(text) + ": ";
  const std::vector<std::string_view> fields = comma_separated(text);
  if (fields.size() != 2 * dimension) {
    throw UsageError(start + "expected " + (dimension == 2 ? "xmin,ymin,xmax,ymax" : "xmin,ymin,zmin,xmax,ymax,zmax") +
                     ", but found " + counted(fields.size(), "number"));
  }
  std::array<double, 3> min{};
  std::array<double, 3> max{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = finite_number(fields[i]);
    if (!value) throw UsageError(start + "expected a finite number, but found '" + std::string(fields[i]) + "'");
    (i < dimension ? min[i] : max[i - dimension]) = *value;
  }
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (!(min[axis] < max[axis]))
      throw UsageError(start + "the minimum of " + "xyz"[axis] + " is not below its maximum");
  }
  if (!std::isfinite(std::hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]))) {
    throw UsageError(start + "expected a diagonal that is a double, at most 1.8e308");
  }
  return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}

/// Lines are broken when the help is printed, and only then.
std::string one_line(std::string help) {
  std::replace(help.begin(), help.end(), '\n', ' ');
  return help;
}

/// What is said of words that no option takes.
std::string unexpected_text(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  const auto is_option = [](const std::string& word) { return word.starts_with("--"); };
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option == words.end()) return "unexpected argument '" + words.back() + "'";
  std::vector<std::string> names;
  for (const CLI::Option* known : app.get_options()) {
    for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return "unknown option '" + *option + "'" + nearest_text(*option, candidates);
}

bool has_unknown_option(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  return std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.starts_with("--"); });
}

/// An empty text is a variable that a script forgot to set, not a wish for the default.
std::string refuse_empty(const std::string& value) {
  return value.empty() ? "is empty" : "";
}

}  // namespace

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_help_flag("-h,--help", "Print this text");
}
CommandLine::~CommandLine() = default;

void CommandLine::add_text(const std::string& name, std::string& text, const std::string& type, const std::string& help,
                           bool is_required) {
  app_->add_option(name, text, one_line(help))->type_name(type)->check(refuse_empty)->required(is_required);
}

void CommandLine::add_texts(const std::string& name, std::vector<std::string>& texts, const std::string& type,
                            const std::string& help) {
  app_->add_option(name, texts, one_line(help))->type_name(type)->check(refuse_empty)->required();
}

void CommandLine::add_flag(const std::string& name, bool& flag, const std::string& help) {
  app_->add_flag(name, flag, one_line(help));
}

void CommandLine::add_flag(const std::string& name, std::string& text, const std::string& help) {
  app_->add_flag(name, text, one_line(help));
}

void CommandLine::add_number(const std::string& name, std::uint32_t& number, const std::string& type,
                             std::uint32_t least, std::uint32_t most, const std::string& help) {
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  app_->add_option(name, number, one_line(help))->type_name(type)->check(CLI::Range(least, most, range));
}

void CommandLine::add_number(const std::string& name, std::uint64_t& number, const std::string& type,
                             const std::string& help) {
  app_->add_option(name, number, one_line(help))->type_name(type);
}

void CommandLine::footer(const std::string& text) {
  app_->footer(text);
}

bool CommandLine::parse(Arguments arguments) {
  // Looked for before parsing, so that help is given even where a required option is missing.
  const auto asks_for_help = [](const std::string& word) { return word == "-h" || word == "--help"; };
  if (std::any_of(arguments.begin(), arguments.end(), asks_for_help)) {
    std::cout << in_columns(app_->help());
    return false;
  }
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // the order CLI11 asks for
  try {
    app_->parse(std::move(reversed));
  } catch (const CLI::ExtrasError&) {
    throw UsageError(unexpected_text(*app_));
  } catch (const CLI::ParseError& error) {
    if (has_unknown_option(*app_)) throw UsageError(unexpected_text(*app_));
    throw UsageError(error.what());
  }
  return true;
}

void add_text(CommandLine& app, const std::string& name, std::string& text, const std::string& type,
              const std::string& help) {
  app.add_text(name, text, type, help, false);
}

void add_required_text(CommandLine& app, const std::string& name, std::string& text, const std::string& type,
                       const std::string& help) {
  app.add_text(name, text, type, help, true);
}

void add_pair_options(CommandLine& app, CommonOptions& options) {
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax",
           "Cut unbounded volumes by this box (default: the scene's, grown by half its diagonal); in scenes of "
           "dimension 2 xmin,ymin,xmax,ymax");
  add_text(app, "--light", options.light, "NAME", "Only the pairs of this light");
  add_text(app, "--blocker", options.blocker, "NAME", "Only the pairs of this blocker");
  add_threads_option(app, options);
  add_quiet_option(app, options);
}

void add_threads_option(CommandLine& app, CommonOptions& options) {
  app.add_number("--threads", options.threads, "N", 1, 1024, "Number of threads (default: one per processor)");
}

void add_json_option(CommandLine& app, CommonOptions& options) {
  add_text(app, "--json", options.json, "FILE",
           "Write the result as JSON; '-' writes it to stdout, and nothing else there");
}

void add_quiet_option(CommandLine& app, CommonOptions& options) {
  app.add_flag("--quiet", options.quiet, "No summary and no progress; warnings and errors only");
}

Box3 clip_box(const Scene& scene, const std::string& box_option) {
  if (!box_option.empty()) return box_from_text(box_option, static_cast<std::size_t>(dimension(scene)));
  if (const auto box = default_clip_box(scene)) return *box;
  throw SceneError(facts(scene).source +
                   ": the scene has no finite bounding box with an interior; give a clip box with --box");
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> comma_separated(std::string_view text) {
  std::vector<std::string_view> fields;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
    fields.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  fields.push_back(text);
  return fields;
}

template <std::size_t N>
std::array<std::uint32_t, N> whole_numbers(const std::string& option, const std::string& text,
                                           const std::string& expected) {
  constexpr std::size_t most = 1'000'000'000;
  const std::vector<std::string_view> fields = comma_separated(text);
  std::array<std::uint32_t, N> numbers{};
  bool good = fields.size() == N;
  std::size_t product = 1;
  for (std::size_t i = 0; good && i < N; ++i) {
    const char* end = fields[i].data() + fields[i].size();
    const auto [stop, error] = std::from_chars(fields[i].data(), end, numbers[i]);
    good = error == std::errc() && stop == end && numbers[i] > 0 && numbers[i] <= most / product;
    product *= numbers[i];
  }
  if (good) return numbers;
  throw UsageError(option + ' ' + text + ": expected " + (N == 2 ? "two" : "three") + " positive whole numbers " +
                   expected + " with at most " + std::to_string(most) + " points");
}

template std::array<std::uint32_t, 2> whole_numbers<2>(const std::string&, const std::string&, const std::string&);
template std::array<std::uint32_t, 3> whole_numbers<3>(const std::string&, const std::string&, const std::string&);

double finite_value(const std::string& option, const std::string& text, const std::string& expected) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && std::isfinite(value)) return value;
  throw UsageError(option + ' ' + text + ": expected " + expected);
}

std::string nearest_text(std::string_view word, std::span<const std::string_view> candidates) {
  const auto distance = [word](std::string_view candidate) { return edit_distance(word, candidate); };
  const std::string_view nearest = *std::ranges::min_element(candidates, {}, distance);
  const std::size_t letters = std::max(word.size(), nearest.size()) - (word.starts_with("--") ? 2 : 0);
  return 3 * distance(nearest) > letters ? "" : "; the nearest is '" + std::string(nearest) + "'";
}

}  // namespace gnomon
