#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "apps/proof/laws/law.h"

// docs/theory.md tells every statement; here it is compared with the list of entries.

namespace gnomon::laws {
namespace {

std::string page() {
  std::ifstream file(GNOMON_DOCS "/theory.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What the page says of a key: from "- **KEY** " to the next item or heading.
std::string item(const std::string& text, const std::string& key) {
  const std::size_t start = text.find("\n- **" + key + "** ");
  if (start == std::string::npos) return "";
  return text.substr(start, text.find("\n\n", start) - start);
}

TEST(TheoryPage, TellsEveryStatement) {
  const std::string text = page();
  for (const std::string& key : all_keys()) EXPECT_NE(item(text, key), "") << key;
}

TEST(TheoryPage, SaysOfFalseClaimsThatTheyAreRefutedAndOfOthersThatTheyHold) {
  const std::string text = page();
  for (const Law& law : all_laws()) {
    const std::string told = item(text, law.key.substr(0, law.key.find('_')));
    const std::regex status(law.standing == Standing::refuted ? "[Rr]efuted" : "Holds;");
    EXPECT_TRUE(std::regex_search(told, status)) << law.key << ": " << told;
  }
}

TEST(TheoryPage, ShowsPicturesThatAreThere) {
  const std::string text = page();
  const std::regex picture("\\]\\((pictures/[^)]+)\\)");
  std::size_t pictures = 0;
  for (auto found = std::sregex_iterator(text.begin(), text.end(), picture); found != std::sregex_iterator(); ++found) {
    ++pictures;
    EXPECT_TRUE(std::filesystem::exists(GNOMON_DOCS "/" + (*found)[1].str())) << (*found)[1];
  }
  EXPECT_GT(pictures, 20u);
}

}  // namespace
}  // namespace gnomon::laws
