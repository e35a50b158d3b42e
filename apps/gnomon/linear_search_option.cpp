#include "apps/gnomon/linear_search_option.h"

#include <algorithm>
#include <charconv>
#include <variant>

#include "apps/gnomon/text.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

std::string names_of_searches() {
  std::string names;
  for (const OccluderSearch search : occluder_searches) {
    names += (names.empty() ? "" : ", ") + std::string(name(search)) + (most_parts(search) > 0 ? "[=N]" : "");
  }
  return names;
}

std::uint32_t parts_of(OccluderSearch search, const std::string& option, std::string_view number) {
  std::uint32_t parts = 0;
  const char* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, parts);
  const std::uint32_t most = most_parts(search);
  if (most == 0) throw UsageError(option + ": '" + std::string(name(search)) + "' takes no number");
  if (error == std::errc() && stop == end && parts > 0 && parts <= most) return parts;
  throw UsageError(option + ": expected a whole number from 1 to " + std::to_string(most) + " after '='");
}

}  // namespace

void add_linear_search_option(CommandLine& app, CommonOptions& options) {
  add_text(app, "--linear-search", options.linear_search, "NAME[=N]",
           "How blockers are found that may hide a linear light: plane, hierarchy,\n"
           "grid[=N] (N x N x N voxels), light_buffer[=N] (N sections about the light)\n"
           "or light_hierarchy (default). Answers are the same, times are not");
}

LinearSearch linear_search(const CommonOptions& options) {
  if (options.linear_search.empty()) return {};
  const std::string_view text = options.linear_search;
  const std::string option = "--linear-search " + options.linear_search;
  const std::size_t equal = text.find('=');
  const auto found =
      std::ranges::find(occluder_searches, text.substr(0, equal), [](OccluderSearch search) { return name(search); });
  if (found == occluder_searches.end()) throw UsageError(option + ": expected one of " + names_of_searches());
  return {*found, equal == std::string_view::npos ? 0 : parts_of(*found, option, text.substr(equal + 1))};
}

LinearSearch linear_search(const CommonOptions& options, const Scene& scene) {
  const LinearSearch search = linear_search(options);
  if (options.linear_search.empty() || std::holds_alternative<SpaceScene>(scene)) return search;
  throw UsageError("--linear-search is for scenes of space; this one is of the plane");
}

}  // namespace gnomon
