#include "apps/gnomon/discontinuity_output.h"

#include <string_view>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/text.h"

namespace gnomon {

std::vector<OutputFormat> tree_formats(const std::string& list) {
  std::vector<OutputFormat> formats;
  for (const std::string_view word : comma_separated(list)) {
    if (word != "vtm" && word != "vtpc") {
      throw UsageError("--format: expected one or both of vtm,vtpc, but found '" + std::string(word) + "'");
    }
    formats.push_back(word == "vtm" ? OutputFormat::vtm : OutputFormat::vtpc);
  }
  return formats;
}

std::string written_files_text(const std::string& folder, const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return {};
  const auto place = [&](const std::filesystem::path& file) {
    return shell_word((std::filesystem::path(folder) / file).string());
  };
  std::string text = "\nwritten    " + place(files.front());
  if (files.size() > 1) text += " and " + counted(files.size() - 1, "other file");
  return text + "\nopen with  paraview --script=" + place("view.py") + "\n";
}

}  // namespace gnomon
