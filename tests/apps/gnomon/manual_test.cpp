#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;

/// What is installed beside the program: GNOMON_MAN_PAGE and GNOMON_COMPLETION are the files.
class Manual : public Program {
 protected:
  /// Without its escapes.
  static std::string man_page() {
    std::ifstream stream(GNOMON_MAN_PAGE);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t at = text.find("\\-"); at != std::string::npos; at = text.find("\\-")) text.erase(at, 1);
    return text;
  }

  /// What bash offers where the last of the words has been begun.
  std::vector<std::string> offered(const std::string& words, int last) const {
    const Outcome run =
        shell("export GNOMON; bash -c '. \"" GNOMON_COMPLETION "\"; COMP_WORDS=(\"$GNOMON\" " + words +
              "); COMP_CWORD=" + std::to_string(last) + "; _gnomon; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    EXPECT_EQ(run.code, 0) << run.err;
    std::istringstream lines(run.out);
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) found.push_back(line);
    return found;
  }
};

TEST_F(Manual, PageHasEveryCommandAndEveryOption) {
  const std::string page = man_page();
  EXPECT_THAT(page, HasSubstr(".TH GNOMON 1 \"\" \"gnomon " GNOMON_VERSION "\""));
  for (const std::string& command : commands_of(gnomon("--help").out)) {
    std::string title = command;
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const std::size_t start = page.find(".SH GNOMON " + title + "\n");
    ASSERT_NE(start, std::string::npos) << command;
    const std::string section = page.substr(start, page.find("\n.SH ", start) - start);
    for (const std::string& option : options_of(gnomon(command + " --help").out)) {
      EXPECT_THAT(section, HasSubstr(option)) << command;
    }
  }
}

TEST_F(Manual, PageIsFormattedWithoutAWarning) {
  if (shell("command -v groff").code != 0) GTEST_SKIP() << "groff (Debian package groff-base) is not installed";
  const Outcome run = shell("groff -man -Tutf8 -ww -z '" GNOMON_MAN_PAGE "'");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, IsEmpty());
}

TEST_F(Manual, PageIsAtMost80ColumnsWide) {
  if (shell("command -v groff").code != 0) GTEST_SKIP() << "groff (Debian package groff-base) is not installed";
  std::istringstream lines(shell("groff -man -Tascii -P-cbou -rLL=80n '" GNOMON_MAN_PAGE "'").out);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_GT(count, 200u);
}

TEST_F(Manual, CompletionOffersCommandsAndTheirOptions) {
  const std::vector<std::string> commands = commands_of(gnomon("--help").out);
  EXPECT_THAT(offered("\"\"", 1), IsSupersetOf(commands));
  EXPECT_THAT(offered("sh", 1), testing::ElementsAre("shadow"));
  for (const std::string& command : commands) {
    EXPECT_THAT(offered(command + " --", 2),
                testing::UnorderedElementsAreArray(options_of(gnomon(command + " --help").out)));
  }
}

TEST_F(Manual, CompletionOffersFilesInPlaceOfAScene) {
  write("table.scene.json", table_scene);
  EXPECT_THAT(offered("check ta", 2), testing::ElementsAre("table.scene.json"));
}

}  // namespace
}  // namespace gnomon
