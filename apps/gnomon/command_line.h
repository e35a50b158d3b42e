#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/commands.h"
#include "gnomon/point.h"
#include "gnomon/scene.h"

namespace CLI {
class App;
}  // namespace CLI

namespace gnomon {

/// The options of one command, each bound to a variable that outlives this, and its help.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& name);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// An option or positional argument with a text that must not be empty; `type` is how help calls the text.
  void add_text(const std::string& name, std::string& text, const std::string& type, const std::string& help,
                bool is_required);
  /// A positional argument that may be repeated, and must be there.
  void add_texts(const std::string& name, std::vector<std::string>& texts, const std::string& type,
                 const std::string& help);
  void add_flag(const std::string& name, bool& flag, const std::string& help);
  /// One that may be followed by '=' and a text; without it the text is "true".
  void add_flag(const std::string& name, std::string& text, const std::string& help);
  void add_number(const std::string& name, std::uint32_t& number, const std::string& type, std::uint32_t least,
                  std::uint32_t most, const std::string& help);
  void add_number(const std::string& name, std::uint64_t& number, const std::string& type, const std::string& help);

  /// What the help ends with.
  void footer(const std::string& text);

  /// Reads the arguments into the variables.
  ///
  /// Returns: false if help was asked for; it has been printed, and nothing else is to be done.
  /// Throws:  UsageError.
  bool parse(Arguments arguments);

 private:
  std::unique_ptr<CLI::App> app_;
};

/// The options that the commands have in common; each takes those that mean something to it.
struct CommonOptions {
  std::string scene;          ///< file name; empty if not given
  std::string box;            ///< as written, see clip_box; empty if not given
  std::string light;          ///< empty: every light
  std::string blocker;        ///< empty: every blocker
  std::string json;           ///< file name, "-" for stdout, empty for none
  std::string linear_search;  ///< as written, see linear_search; empty if not given
  unsigned threads = 0;       ///< 0: as many as there are processors
  bool quiet = false;
};

/// Adds an option or positional argument that may be left out, or must be there: see CommandLine.
void add_text(CommandLine& app, const std::string& name, std::string& text, const std::string& type,
              const std::string& help);
void add_required_text(CommandLine& app, const std::string& name, std::string& text, const std::string& type,
                       const std::string& help);

/// Adds --box, --light, --blocker, --threads and --quiet.
void add_pair_options(CommandLine& app, CommonOptions& options);

/// Adds --json.
void add_json_option(CommandLine& app, CommonOptions& options);

/// Adds --threads.
void add_threads_option(CommandLine& app, CommonOptions& options);

/// Adds --quiet alone.
void add_quiet_option(CommandLine& app, CommonOptions& options);

/// The box that cuts a scene's volumes: the one given with --box, or else the scene's default.
///
/// Throws: UsageError unless --box holds two finite numbers per dimension, each minimum below its maximum, and a finite
///         diagonal;
///         SceneError if the scene has no default box.
Box3 clip_box(const Scene& scene, const std::string& box_option);

/// The number that the whole text is; nothing if it is none, or not finite.
std::optional<double> finite_number(std::string_view text);

/// The items of a list like "a,b,c".
std::vector<std::string_view> comma_separated(std::string_view text);

/// N positive whole numbers separated by commas, with a product of at most a billion: the numbers of points along the
/// sides of a grid. `option` and `expected` are how messages call the option and its form.
///
/// Throws: UsageError for another text.
template <std::size_t N>
std::array<std::uint32_t, N> whole_numbers(const std::string& option, const std::string& text,
                                           const std::string& expected);

/// The finite number that the text holds.
///
/// Throws: UsageError for another text.
double finite_value(const std::string& option, const std::string& text, const std::string& expected);

/// "; the nearest is 'WORD'" with the candidate that differs from the word by the fewest letters, dashes in front
/// apart; nothing if these are more than a third.
///
/// Requires: at least one candidate.
std::string nearest_text(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace gnomon
