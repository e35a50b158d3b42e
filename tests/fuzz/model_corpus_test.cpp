#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void replay(const std::filesystem::path& file) {
  SCOPED_TRACE(file.string());
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
}

TEST(ModelCorpus, ReplaysWithoutAnyExceptionButRefusals) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GNOMON_FUZZ_CORPUS "/model")) {
    replay(entry.path());
    ++files;
  }
  EXPECT_GT(files, 30u);
}

}  // namespace
