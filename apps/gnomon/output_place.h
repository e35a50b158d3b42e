#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// What an option takes the name of.
enum class OutputKind {
  folder,   ///< of a result
  csv,      ///< "-" is stdout
  json,     ///< "-" is stdout
  image,    ///< VTK image data
  picture,  ///< PNG, PFM or VTK image data
  text,     ///< lines of numbers, of any ending that no other kind has; never stdout
};

/// Refuses a name whose ending says that something else is meant (a folder `out.vtm`, a table `points.json`), and "-"
/// where a result does not go to stdout. An empty name is an option that was not given.
///
/// Throws: UsageError telling what would do.
void require_place(std::string_view option, const std::string& name, OutputKind kind);

/// Refuses a file to write that is one of those to read.
void require_unread(std::string_view option, const std::string& name, const std::vector<std::string>& read);

/// Refuses a file to write that another option writes, too.
void require_unwritten(std::string_view option, const std::string& name, const std::vector<std::string>& written);

/// require_place and require_unread for a table and its JSON, which must not both go to one file, or to stdout.
void require_table_places(const std::string& out, const std::string& json, const std::vector<std::string>& read);

/// Makes sure that a folder may be written into: require_place, and nothing of others in the way; and that its JSON
/// is neither a file of the folder's own nor one to read.
void require_result_places(const std::string& folder, const std::string& json, const std::vector<std::string>& read);

/// Warns of results in the folder that other commands have written of another scene or box.
void warn_of_outdated_results(const std::string& folder);

}  // namespace gnomon
