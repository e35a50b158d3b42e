#include "gnomon/writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "gnomon/errors.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Files may not grow beyond a size while this lives, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

std::size_t files_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

void expect_sample_in(const fs::path& folder) {
  EXPECT_EQ(read_multiblock(folder / "shadow.vtm").blocks.size(), 11u);
  EXPECT_EQ(read_json(folder / "manifest.json").at("pairs").size(), 2u);
}

TEST(ShadowWriter, ReturnsWhatItHasWritten) {
  const TemporaryFolder folder;
  const SampleResult sample;
  const auto files = write_shadow(sample.result(), folder / "new/folder");
  EXPECT_EQ(files.front(), "shadow.vtm");
  EXPECT_THAT(files, testing::IsSupersetOf({fs::path("manifest.json"), fs::path("view.py")}));
  for (const fs::path& file : files) EXPECT_TRUE(fs::is_regular_file(folder / "new/folder" / file)) << file;
  EXPECT_EQ(files_in(folder.path()), files.size());
}

TEST(ShadowWriter, WritesTheSameBytesAgain) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  const SampleResult sample;
  const auto files = write_shadow(sample.result(), one.path());
  write_shadow(sample.result(), two.path());
  write_shadow(sample.result(), two.path());
  for (const fs::path& file : files) EXPECT_EQ(file_text(one.path() / file), file_text(two.path() / file)) << file;
  EXPECT_EQ(files_in(two.path()), files.size());
}

TEST(ShadowWriter, RemovesWhatAnEarlierRunLeftBehind) {
  const TemporaryFolder folder;
  write_shadow(SampleResult("old lamp").result(), folder.path(), {{OutputFormat::vtm, OutputFormat::obj}});
  ASSERT_TRUE(fs::exists(folder / "shadow/volumes/old%20lamp/table/umbra.vtp"));
  ASSERT_TRUE(fs::exists(folder / "shadow.obj"));
  const auto files = write_shadow(SampleResult().result(), folder.path());
  EXPECT_FALSE(fs::exists(folder / "shadow/volumes/old%20lamp"));
  EXPECT_FALSE(fs::exists(folder / "shadow.obj"));
  EXPECT_EQ(files_in(folder.path()), files.size());
}

TEST(ShadowWriter, LeavesFilesOfOthersAlone) {
  const TemporaryFolder folder;
  write_shadow(SampleResult("old").result(), folder.path());
  write_file(folder / "notes.txt", "mine");
  write_file(folder / "shadow/volumes/old/notes.txt", "mine too");
  write_shadow(SampleResult().result(), folder.path());
  EXPECT_EQ(file_text(folder / "notes.txt"), "mine");
  EXPECT_EQ(file_text(folder / "shadow/volumes/old/notes.txt"), "mine too");
}

TEST(ShadowWriter, RemovesNothingElseWhateverAnEarlierManifestSays) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_file(folder / "precious.txt", "mine");
  write_file(folder / "out/notes.txt", "mine");
  write_file(
      folder / "out/manifest.json",
      R"({"schema": "gnomon/manifest/1", "files": ["../precious.txt", "shadow/../../precious.txt", "notes.txt"]})");
  write_shadow(SampleResult().result(), folder / "out");
  EXPECT_EQ(file_text(folder / "precious.txt"), "mine");
  EXPECT_EQ(file_text(folder / "out/notes.txt"), "mine");
}

TEST(ShadowWriter, CleansUpAfterAKilledRun) {
  const TemporaryFolder folder;
  // No process has a number this large.
  fs::create_directories(folder / ".gnomon-2000000000-0/shadow");
  write_file(folder / ".gnomon-2000000000-0/shadow/half.vtp", "half a file");
  write_shadow(SampleResult().result(), folder.path());
  EXPECT_FALSE(fs::exists(folder / ".gnomon-2000000000-0"));
}

TEST(ShadowWriter, LeavesTheEarlierResultWhenItFails) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder.path());
  const std::string before = file_text(folder / "shadow/volumes/lamp/table/umbra.vtp");
  SampleResult other;
  remove_umbra(other.result());
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{500}, rlim_t{5000}}) {
    const FullDisk full(bytes);
    EXPECT_THROW(write_shadow(other.result(), folder.path()), std::runtime_error);
  }
  expect_sample_in(folder.path());
  EXPECT_EQ(file_text(folder / "shadow/volumes/lamp/table/umbra.vtp"), before);
}

TEST(ShadowWriter, NamesTheFileForWhichThereIsNoRoom) {
  const TemporaryFolder folder;
  const SampleResult sample;
  const FullDisk full(200);
  testing::internal::CaptureStderr();
  EXPECT_THAT([&] { write_shadow(sample.result(), folder.path()); },
              ThrowsMessage<std::runtime_error>(HasSubstr((folder / "shadow/scene/lights/lamp.vtp").string())));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT([&] { write_shadow(sample.result(), folder.path(), {{OutputFormat::obj}}); },
              ThrowsMessage<std::runtime_error>(HasSubstr((folder / "shadow.obj").string())));
}

TEST(ShadowWriter, NamesTheFolderThatCannotBeMade) {
  const TemporaryFolder folder;
  write_file(folder / "file", "not a folder");
  EXPECT_THAT([&] { write_shadow(SampleResult().result(), folder / "file"); },
              ThrowsMessage<std::runtime_error>(HasSubstr((folder / "file").string())));
  EXPECT_THAT([&] { write_shadow(SampleResult().result(), folder / "file/below"); },
              ThrowsMessage<std::runtime_error>(HasSubstr((folder / "file/below").string())));
}

TEST(ShadowWriter, ReplacesNothingWhereAFolderStandsInTheWay) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder.path());
  fs::remove(folder / "view.py");
  fs::create_directory(folder / "view.py");
  SampleResult other;
  remove_umbra(other.result());
  EXPECT_THAT([&] { write_shadow(other.result(), folder.path()); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("view.py"), HasSubstr("directory"))));
  expect_sample_in(folder.path());
}

TEST(ShadowWriter, RefusesAResultWithoutAScene) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_shadow(ShadowResult{}, folder.path()), PreconditionError);
}

TEST(ShadowWriter, KnowsItsFormatsByName) {
  for (const char* word : {"vtm", "vtpc", "vtp", "obj", "stl", "gltf"}) {
    ASSERT_TRUE(output_format(word).has_value()) << word;
    EXPECT_EQ(name(*output_format(word)), word);
  }
  EXPECT_FALSE(output_format("vtk").has_value());
}

}  // namespace
}  // namespace gnomon
