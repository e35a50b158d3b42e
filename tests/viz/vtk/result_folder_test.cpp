#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vtkFieldData.h>

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "gnomon/errors.h"
#include "gnomon/picture.h"
#include "gnomon/writer.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"
#include "viz/vtk/discontinuity_writer.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr const char* umbra_leaf = "shadow/volumes/lamp/table/umbra.vtp";

/// Receivers without a light: the elements of the scene are all that is written.
DiscontinuityResult scene_alone(const ShadowResult& result) {
  return {result.scene, result.clip_box, {}, {}};
}

void write_receivers(const SampleResult& sample, const fs::path& folder) {
  write_discontinuities(scene_alone(sample.result()), DiscontinuityOutput::receivers, folder, {OutputFormat::vtm});
}

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "done";
}

/// A small picture that needs no display.
std::string drawing_of(const fs::path& folder) {
  const TemporaryFolder place;
  return refusal_of([&] { render_result(folder, place / "picture.gltf"); });
}

TEST(ResultFolder, EveryLeafCarriesTheGenerationThatTheManifestNames) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder.path());
  const nlohmann::json manifest = read_json(folder / "manifest.json");
  const std::string generation = manifest.at("generation");
  EXPECT_EQ(generation.size(), 16u);
  const ReadTree tree = read_multiblock(folder / "shadow.vtm");
  EXPECT_EQ(field_text(tree.fields, "generation"), generation);
  for (const auto& [name, block] : tree.blocks) {
    EXPECT_EQ(field_text(block->GetFieldData(), "generation"), generation) << name;
  }
  for (const auto& block : manifest.at("blocks")) EXPECT_EQ(block.at("generation"), generation);
}

TEST(ResultFolder, AnotherSceneOrBoxIsAnotherGeneration) {
  const TemporaryFolder folder;
  std::set<std::string> generations;
  SampleResult wider;
  wider.result().clip_box.max.x += 1;
  const SampleResult plain, same, renamed("bulb");
  for (const SampleResult* sample : {&plain, &same, &renamed, const_cast<const SampleResult*>(&wider)}) {
    write_shadow(sample->result(), folder.path());
    generations.insert(read_json(folder / "manifest.json").at("generation"));
  }
  EXPECT_EQ(generations.size(), 3u);
}

TEST(ResultFolder, ALeafOfAnotherGenerationIsRefused) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder / "one");
  SampleResult other;
  other.result().clip_box.max.x += 1;
  write_shadow(other.result(), folder / "two");
  ASSERT_EQ(drawing_of(folder / "one"), "done");
  fs::copy_file(folder / "two" / umbra_leaf, folder / "one" / umbra_leaf, fs::copy_options::overwrite_existing);
  EXPECT_THAT([&] { render_result(folder / "one", folder / "picture.gltf"); },
              ThrowsMessage<ResultError>(AllOf(HasSubstr(umbra_leaf), HasSubstr("another run"))));
  // Solids are not drawn, but tell as much.
  write_shadow(SampleResult().result(), folder / "one");
  const std::string solid = "shadow/solids/lamp/table/umbra.vtu";
  fs::copy_file(folder / "two" / solid, folder / "one" / solid, fs::copy_options::overwrite_existing);
  EXPECT_THAT([&] { render_result(folder / "one", folder / "picture.gltf"); },
              ThrowsMessage<ResultError>(AllOf(HasSubstr(solid), HasSubstr("another run"))));
}

TEST(ResultFolder, ResultsOfOtherCommandsStay) {
  const TemporaryFolder folder;
  const SampleResult sample;
  write_shadow(sample.result(), folder.path());
  write_receivers(sample, folder.path());
  EXPECT_TRUE(fs::exists(folder / "shadow.vtm"));
  EXPECT_TRUE(fs::exists(folder / umbra_leaf));
  EXPECT_THAT(outdated_roots(folder.path()), IsEmpty());
  write_shadow(sample.result(), folder.path());
  EXPECT_TRUE(fs::exists(folder / "receivers.vtm"));
  EXPECT_EQ(drawing_of(folder.path()), "done");
}

TEST(ResultFolder, AResultIsRemovedByTheNextOfItsOwnCommandEvenIfAnotherCameBetween) {
  const TemporaryFolder folder;
  const SampleResult sample;
  write_shadow(sample.result(), folder.path(), {{OutputFormat::vtm, OutputFormat::obj}});
  write_receivers(sample, folder.path());
  write_shadow(sample.result(), folder.path());
  EXPECT_FALSE(fs::exists(folder / "shadow.obj"));
}

TEST(ResultFolder, ResultsThatTheNewSceneHasOutdatedAreNamed) {
  const TemporaryFolder folder;
  write_receivers(SampleResult(), folder.path());
  write_shadow(SampleResult("bulb").result(), folder.path());
  EXPECT_THAT(outdated_roots(folder.path()), ElementsAre("receivers.vtm"));
}

TEST(ResultFolder, FilesOfOthersAreNotReplacedAndNothingElseIsWrittenThen) {
  for (const std::string name : {"manifest.json", "view.py", "shadow.vtm"}) {
    const TemporaryFolder folder;
    write_file(folder / name, "mine");
    EXPECT_THAT(refusal_of([&] { write_shadow(SampleResult().result(), folder.path()); }),
                AllOf(HasSubstr(name), HasSubstr("not gnomon's")));
    EXPECT_EQ(file_text(folder / name), "mine");
    EXPECT_FALSE(fs::exists(folder / "shadow"));
  }
}

TEST(ResultFolder, AScriptOfTheUsersIsNotReplacedThoughAManifestListsOneOfThatName) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder.path());
  write_file(folder / "view.py", "print('mine')\n");
  EXPECT_THAT(refusal_of([&] { write_shadow(SampleResult().result(), folder.path()); }), HasSubstr("view.py"));
  EXPECT_EQ(file_text(folder / "view.py"), "print('mine')\n");
}

TEST(ResultFolder, WhatIsRefusedInTheEndIsRefusedBeforeAnythingIsComputed) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(require_result_folder(folder / "missing"));
  write_file(folder / "view.py", "mine");
  EXPECT_THROW(require_result_folder(folder.path()), std::runtime_error);
}

TEST(ResultFolder, AFolderThatAStoppedRunLeftIsWrittenAgain) {
  const TemporaryFolder folder;
  write_shadow(SampleResult("old").result(), folder.path());
  fs::remove(folder / "manifest.json");
  write_shadow(SampleResult().result(), folder.path());
  EXPECT_EQ(drawing_of(folder.path()), "done");
}

TEST(ResultFolder, WritesNothingThroughALinkThatLeadsElsewhere) {
  const TemporaryFolder folder, elsewhere;
  write_file(elsewhere / "precious", "mine");
  fs::create_directory_symlink(elsewhere.path(), folder / "shadow");
  EXPECT_THAT(refusal_of([&] { write_shadow(SampleResult().result(), folder.path()); }), HasSubstr("is a link"));
  EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere.path()), fs::directory_iterator()), 1);
  EXPECT_FALSE(fs::exists(folder / "manifest.json"));
}

TEST(ResultFolder, RemovesNothingThroughALinkWhateverTheEarlierManifestSays) {
  const TemporaryFolder folder, elsewhere;
  write_shadow(SampleResult("old").result(), elsewhere.path());
  write_shadow(SampleResult().result(), folder.path());
  fs::create_directory_symlink(elsewhere / "shadow", folder / "shadow_1");
  nlohmann::json manifest = read_json(folder / "manifest.json");
  for (const char* file : {"shadow_1/volumes/old/table/umbra.vtp", "../view.py", "/etc/hostname", "shadow_notes.vtp"}) {
    manifest["files"].push_back(file);
  }
  write_file(folder / "manifest.json", manifest.dump(1));
  write_file(folder / "shadow_notes.vtp", "mine");
  write_shadow(SampleResult().result(), folder.path());
  EXPECT_TRUE(fs::exists(elsewhere / "shadow/volumes/old/table/umbra.vtp"));
  EXPECT_EQ(file_text(folder / "shadow_notes.vtp"), "mine");
}

TEST(ResultFolder, ReadsNothingOutsideAndWaitsForNoPipe) {
  const TemporaryFolder folder;
  const std::string hostile[] = {"../one/" + std::string(umbra_leaf),
                                 (folder / "one" / umbra_leaf).string(),
                                 "link.vtp",
                                 "pipe.vtp",
                                 "folder.vtp",
                                 "missing.vtp"};
  write_shadow(SampleResult().result(), folder / "one");
  for (const std::string& name : hostile) {
    const fs::path two = folder / "two";
    fs::remove_all(two);
    write_shadow(SampleResult().result(), two);
    fs::create_symlink(folder / "one" / umbra_leaf, two / "link.vtp");
    ASSERT_EQ(::mkfifo((two / "pipe.vtp").c_str(), 0600), 0);
    fs::create_directory(two / "folder.vtp");
    nlohmann::json manifest = read_json(two / "manifest.json");
    manifest["blocks"][0]["file"] = name;
    write_file(two / "manifest.json", manifest.dump());
    EXPECT_THAT(drawing_of(two), HasSubstr("cannot read")) << name;
  }
}

TEST(ResultFolder, AManifestThatIsNoneIsRefused) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder / "result");
  const nlohmann::json good = read_json(folder / "result/manifest.json");
  const auto drawn = [&](const nlohmann::json& manifest) {
    write_file(folder / "result/manifest.json", manifest.dump());
    return drawing_of(folder / "result");
  };
  ASSERT_EQ(drawn(good), "done");
  const std::pair<const char*, nlohmann::json> changes[] = {{"/dimension", 7},
                                                            {"/dimension", "3"},
                                                            {"/blocks", 3},
                                                            {"/blocks/0/path", "a"},
                                                            {"/blocks/0/file", 5},
                                                            {"/pairs", {1}},
                                                            {"/schema", "x"},
                                                            {"/field_data/scene", nlohmann::json::array()},
                                                            {"/field_data/clip_box", {0, 0, 0, 1, 1}},
                                                            {"/field_data/clip_box", {0, 0, 0, 1, 1, -1}},
                                                            {"/field_data/clip_box", {-1e308, 0, 0, 1e308, 1, 1}},
                                                            {"/blocks/0/generation", 5}};
  for (const auto& [pointer, value] : changes) {
    nlohmann::json bad = good;
    bad[nlohmann::json::json_pointer(pointer)] = value;
    EXPECT_THAT(drawn(bad), HasSubstr("cannot read")) << pointer << ' ' << value;
  }
  write_file(folder / "result/manifest.json", std::string(100000, '['));
  EXPECT_THAT(drawing_of(folder / "result"), HasSubstr("cannot read"));
}

/// The leaf's first cell with a point that is not there; the file is as VTK writes it in text.
constexpr const char* unsound = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 99999999</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></Polys>
</Piece></PolyData></VTKFile>)";

TEST(ResultFolder, ALeafWhoseCellsHavePointsThatAreNotThereIsRefused) {
  const TemporaryFolder folder;
  write_shadow(SampleResult().result(), folder / "result");
  write_file(folder / "result" / umbra_leaf, unsound);
  EXPECT_THAT(drawing_of(folder / "result"), AllOf(HasSubstr("cannot read"), HasSubstr(umbra_leaf)));
}

TEST(ResultFolder, IsWrittenByOneProcessAtATime) {
  const TemporaryFolder folder;
  const int other = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  EXPECT_THAT(refusal_of([&] { write_shadow(SampleResult().result(), folder.path()); }),
              AllOf(HasSubstr("another gnomon"), HasSubstr(folder.path().string())));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  ::close(other);
  write_shadow(SampleResult().result(), folder.path());
  EXPECT_EQ(drawing_of(folder.path()), "done");
}

TEST(ResultFolder, OnlyHiddenFoldersOfOursAreCleanedUp) {
  const TemporaryFolder folder, elsewhere;
  write_file(elsewhere / "precious", "mine");
  for (const char* name : {".gnomon-999999-my-data", ".gnomon-999999-", ".gnomon-999999", ".gnomon--5-0", ".gnomon-x-0",
                           ".gnomon-2000000000-1x", ".gnomon-2000000000-0"}) {
    fs::create_directory(folder / name);
    write_file(folder.path() / name / "file", "mine");
  }
  write_file(folder / ".gnomon-2000000000-2", "a file");
  fs::create_directory_symlink(elsewhere.path(), folder / ".gnomon-2000000000-3");
  write_shadow(SampleResult().result(), folder / "");
  EXPECT_FALSE(fs::exists(folder / ".gnomon-2000000000-0"));
  for (const char* name : {".gnomon-999999-my-data", ".gnomon-999999-", ".gnomon-999999", ".gnomon--5-0", ".gnomon-x-0",
                           ".gnomon-2000000000-1x", ".gnomon-2000000000-2", ".gnomon-2000000000-3"}) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  EXPECT_EQ(file_text(elsewhere / "precious"), "mine");
}

}  // namespace
}  // namespace gnomon
