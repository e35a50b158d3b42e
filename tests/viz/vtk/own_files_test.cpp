#include "viz/vtk/own_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "gnomon/writer.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "viz/vtk/discontinuity_writer.h"

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

const std::vector<OutputFormat> every_format = {OutputFormat::vtm, OutputFormat::vtpc, OutputFormat::vtp,
                                                OutputFormat::obj, OutputFormat::stl,  OutputFormat::gltf};

TEST(OwnFiles, EveryFileThatIsWrittenSaysThatItIsOurs) {
  const TemporaryFolder folder;
  const SampleResult sample("lamp <&> \"one\"");
  for (const fs::path& file : write_shadow(sample.result(), folder.path(), {every_format})) {
    EXPECT_TRUE(says_it_is_ours(folder.path() / file)) << file;
    EXPECT_TRUE(file == "manifest.json" || may_be_ours(file)) << file;
  }
  SeriesWriter series(folder / "series");
  series.add(0, sample.result());
  for (const fs::path& file : series.publish()) {
    EXPECT_TRUE(says_it_is_ours(folder.path() / "series" / file)) << file;
    EXPECT_TRUE(file == "manifest.json" || may_be_ours(file)) << file;
  }
}

TEST(OwnFiles, FilesOfOthersDoNot) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> others[] = {
      {"manifest.json", R"({"name": "my web app", "schema": "other/manifest/1"})"},
      {"view.py", "print('mine')\n"},
      {"shadow.vtm", "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\">\n</VTKFile>\n"},
      {"shadow.obj", "# Blender\nv 0 0 0\n"},
      {"shadow.gltf", R"({"asset": {"version": "2.0", "generator": "another"}})"},
      {"umbra.stl", "my notes on solids\n"},
      {"umbra.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n</VTKFile>\n"},
      {"empty.vtp", ""},
      {"notes.txt", "gnomon"}};
  for (const auto& [name, text] : others) {
    write_file(folder / name, text);
    EXPECT_FALSE(says_it_is_ours(folder / name)) << name;
  }
  EXPECT_FALSE(says_it_is_ours(folder / "missing.json"));
}

TEST(OwnFiles, LinksPipesAndFoldersSayNothing) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder.path());
  fs::create_symlink(folder / "manifest.json", folder / "link.json");
  fs::create_directory(folder / "folder.json");
  ASSERT_EQ(::mkfifo((folder / "pipe.json").c_str(), 0600), 0);
  for (const char* name : {"link.json", "folder.json", "pipe.json"})
    EXPECT_FALSE(says_it_is_ours(folder / name)) << name;
}

TEST(OwnFiles, NamesThatLeadOutOfAFolderAreFound) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  fs::create_directories(folder / "shadow/volumes");
  write_file(folder / "file", "");
  fs::create_directory_symlink(elsewhere.path(), folder / "shadow/link");
  for (const char* name : {"view.py", "shadow/new/umbra.vtp", "shadow/volumes/umbra.vtp", "shadow/..umbra.vtp"}) {
    EXPECT_EQ(way_out(folder.path(), name), "") << name;
  }
  for (const char* name : {"", "/etc/passwd", "..", "../view.py", "shadow/../../view.py", "shadow/..",
                           "shadow/link/a.vtp", "shadow/link/b/a.vtp", "file/a.vtp"}) {
    EXPECT_NE(way_out(folder.path(), name), "") << name;
  }
}

TEST(OwnFiles, OnlyNamesOfResultsMayBeOurs) {
  for (const char* name : {"shadow.vtm", "view.py", "receivers.vtpc", "shadow/a/b.vtu", "shadow_0000/shadow.vtm",
                           "shadow_12/shadow/x.vtp"}) {
    EXPECT_TRUE(may_be_ours(name)) << name;
  }
  for (const char* name : {"notes.txt", "shadow_of_doubt.vtp", "shadows/a.vtp", "shadow_/a.vtp", "shadow_1x/a.vtp",
                           "shadow/notes.txt", "receivers.vtu", "receivers/a.vtp", "shadow.vtm/notes.txt"}) {
    EXPECT_FALSE(may_be_ours(name)) << name;
  }
}

}  // namespace
}  // namespace gnomon::viz
