#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "apps/proof/kill_matrix.h"
#include "apps/proof/law_trials.h"
#include "apps/proof/laws/mutants.h"
#include "apps/proof/proof_commands.h"
#include "apps/proof/theorem_files.h"
#include "apps/proof/theorems_output.h"
#include "gnomon/picture.h"

namespace gnomon {
namespace {

struct TheoremsOptions : CommonOptions {
  std::uint32_t cases = 1000;
  std::uint64_t seed = 1;
  std::string only;
  std::string out;
  std::string mutant;
  bool mutants = false;

  Effort effort() const { return {threads, !quiet}; }
};

void add_options(CommandLine& app, TheoremsOptions& options) {
  app.add_number("--cases", options.cases, "N", 1, 1'000'000'000,
                 "Cases of every statement, half of them nearly degenerate (default: 1000)");
  app.add_number("--seed", options.seed, "S", "The cases are the same for the same seed (default: 1)");
  add_text(app, "--only", options.only, "KEY,...", "Only these statements");
  add_text(app, "--out", options.out, "DIR", "Write counterexamples as scenes, points and pictures into this folder");
  add_json_option(app, options);
  add_text(app, "--mutant", options.mutant, "NAME", "Try the statements on a program with this mistake");
  app.add_flag("--mutants", options.mutants,
               "Print which statement catches which mistake, within 1,000 random cases or 1,000 nearly degenerate ones "
               "after them");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each statement is decided exactly, case by case, against the definition. Cases are those in which the premise\n"
      "of a statement holds; 'premise' is their share of all cases drawn. Seconds are processor time. A statement\n"
      "that fails is shrunk to a small case and written as KEY.scene.json with its points KEY.csv, into the folder\n"
      "of --out or the current one; 'gnomon regions KEY.scene.json --at KEY.csv' shows what the program says there.\n"
      "The exit code is 1 if a statement fails or a false claim is no longer refuted.\n\n"
      "Examples:\n"
      "  gnomon theorems --cases 40\n"
      "  gnomon theorems --only S4,F1 --seed 7 --json theorems.json\n");
}

laws::Law law_called(std::string_view key, const std::vector<laws::Law>& laws) {
  const auto found = std::ranges::find(laws, key, &laws::Law::key);
  if (found != laws.end()) return *found;
  const std::vector<std::string> keys = laws::all_keys();
  const std::vector<std::string_view> words(keys.begin(), keys.end());
  throw UsageError("--only: there is no statement '" + std::string(key) + "'" + nearest_text(key, words));
}

/// The laws asked for, in the order of the theory, each once.
std::vector<laws::Law> chosen_laws(const std::string& only) {
  std::vector<laws::Law> all = laws::all_laws();
  if (only.empty()) return all;
  std::vector<std::string> keys;
  for (const std::string_view key : comma_separated(only)) keys.push_back(law_called(key, all).key);
  std::erase_if(all, [&](const laws::Law& law) { return std::ranges::find(keys, law.key) == keys.end(); });
  return all;
}

laws::Subject chosen_subject(const std::string& name) {
  if (name.empty()) return {};
  const std::vector<laws::Mutant> mutants = laws::all_mutants();
  std::vector<std::string_view> names;
  for (const laws::Mutant& mutant : mutants) names.push_back(mutant.name);
  const auto found = std::ranges::find(mutants, name, &laws::Mutant::name);
  if (found != mutants.end()) return found->subject;
  throw UsageError("--mutant: there is no mistake called '" + name + "'" + nearest_text(name, names));
}

ExitCode print_matrix(const TheoremsOptions& options) {
  const KillMatrix matrix = kill_matrix(chosen_laws(options.only), options.seed, options.effort());
  if (!options.json.empty()) write_json(matrix_json(matrix), options.json);
  if (options.json != "-") std::cout << matrix_text(matrix);
  // Asked about some laws only, the matrix need not catch everything.
  const std::vector<std::string> alive = options.only.empty() ? survivors(matrix) : std::vector<std::string>{};
  for (const std::string& name : alive) print_error("the mistake '" + name + "' is not caught where it should be");
  return alive.empty() ? ExitCode::done : ExitCode::failure;
}

/// Draws the scenes written; without a display the rest of what was asked for is worth having, so that is a warning.
std::vector<std::string> drawn_examples(const std::vector<std::string>& keys, const TheoremsOptions& options) {
  std::vector<std::string> files;
  try {
    for (const std::string& key : keys) {
      for (std::string& file : draw_example(key, options.out, {options.threads, false})) files.push_back(file);
    }
  } catch (const NoDisplayError& error) {
    print_warning(std::string("no pictures: ") + error.what());
  }
  return files;
}

/// Writes what can be shown: with --out all counterexamples, and pictures of them; without, those of laws that failed.
std::vector<std::string> written_examples(const std::vector<LawTrial>& trials, const TheoremsOptions& options) {
  std::vector<std::string> files, keys;
  const auto add = [&](const std::vector<std::string>& more) { files.insert(files.end(), more.begin(), more.end()); };
  for (const LawTrial& trial : trials) {
    const std::optional<laws::Example>& example = shown_example(trial);
    if (!example || (options.out.empty() && !trial.failed())) continue;
    add(write_example(*example, trial.law.key, options.out.empty() ? "." : options.out));
    keys.push_back(trial.law.key);
  }
  if (!options.out.empty()) add(drawn_examples(keys, options));
  return files;
}

void warn_of_rare_premises(const std::vector<LawTrial>& trials, std::uint32_t cases) {
  for (const LawTrial& trial : trials) {
    if (trial.failed() || trial.outcome.premise_held >= cases) continue;
    print_warning(trial.law.key + ": the premise held in only " + counted(trial.outcome.premise_held, "case"));
  }
}

void print_trials(const std::vector<LawTrial>& trials, const TrialOptions& options) {
  std::cout << trials_table(trials) << '\n';
  const std::string census = census_table(trials);
  if (!census.empty()) std::cout << "Regions of the cases\n" << census << '\n';
  for (const LawTrial& trial : trials) {
    if (trial.status != LawStatus::holds) std::cout << counterexample_text(trial, options) << '\n';
  }
}

void print_sum(const std::vector<LawTrial>& trials, double seconds) {
  std::size_t failed = 0, refuted = 0;
  double processor = 0;
  for (const LawTrial& trial : trials) {
    failed += trial.failed() ? 1 : 0;
    refuted += trial.status == LawStatus::refuted ? 1 : 0;
    processor += trial.seconds;
  }
  std::cout << counted(trials.size(), "statement") << ": " << trials.size() - failed - refuted << " hold, " << refuted
            << " refuted as expected, " << failed << " failed; " << std::llround(seconds) << " s, "
            << std::llround(processor) << " s of processor time\n";
}

ExitCode check_theorems(const TheoremsOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const TrialOptions trial_options{options.cases, options.seed, chosen_subject(options.mutant), options.mutant};
  const std::vector<LawTrial> trials = law_trials(chosen_laws(options.only), trial_options, options.effort());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!options.json.empty()) write_json(trials_json(trials, trial_options), options.json);
  const bool prints = options.json != "-" && !options.quiet;
  if (prints) print_trials(trials, trial_options);
  for (const std::string& file : written_examples(trials, options)) {
    if (prints) std::cout << "written    " << shell_word(file) << '\n';
  }
  if (prints) print_sum(trials, seconds);
  warn_of_rare_premises(trials, options.cases);
  bool failed = false;
  for (const LawTrial& trial : trials) {
    if (!trial.failed()) continue;
    failed = true;
    print_error(counterexample_text(trial, trial_options));
  }
  return failed ? ExitCode::failure : ExitCode::done;
}

}  // namespace

ExitCode theorems_command(Arguments arguments) {
  CommandLine app(
      "Checks the statements of the theory that the program rests on, on random and on nearly degenerate cases, and\n"
      "shows that the false ones are false.",
      "gnomon theorems");
  TheoremsOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  if (options.mutants && (!options.mutant.empty() || !options.out.empty())) {
    throw UsageError("--mutants tries every mistake and writes no scenes; leave out --mutant and --out");
  }
  return options.mutants ? print_matrix(options) : check_theorems(options);
}

}  // namespace gnomon
