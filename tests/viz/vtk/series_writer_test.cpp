#include "gnomon/writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gnomon/errors.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"

namespace gnomon {
namespace {

using testing::HasSubstr;

TEST(SeriesWriter, WritesWhatAResultByItselfIsWrittenAs) {
  const TemporaryFolder folder;
  const SampleResult sample;
  write_shadow(sample.result(), folder / "alone");
  SeriesWriter writer(folder / "series");
  writer.add(0.5, sample.result());
  EXPECT_EQ(writer.publish().front(), "shadow.pvd");
  for (const std::string file : {"shadow.vtm", "shadow/volumes/lamp/table/umbra.vtp", "shadow/scene/lights/lamp.vtp"}) {
    EXPECT_EQ(file_text(folder / ("series/shadow_0000/" + file)), file_text(folder / ("alone/" + file))) << file;
  }
  EXPECT_THAT(file_text(folder / "series/shadow.pvd"), HasSubstr("timestep=\"0.5\""));
}

TEST(SeriesWriter, ListsABlockThatOnlySomeTimesHave) {
  const TemporaryFolder folder;
  SampleResult with;
  SampleResult without;
  remove_umbra(without.result());
  for (const bool first : {true, false}) {
    SeriesWriter writer(folder / "series");
    writer.add(0, first ? with.result() : without.result());
    writer.add(1, first ? without.result() : with.result());
    writer.publish();
    const auto manifest = nlohmann::json::parse(file_text(folder / "series/manifest.json"));
    std::string file;
    for (const auto& block : manifest.at("blocks")) {
      if (block.at("name") == "volumes/lamp/table/umbra") file = block.at("file");
    }
    EXPECT_EQ(file, std::string(first ? "shadow_0000" : "shadow_0001") + "/shadow/volumes/lamp/table/umbra.vtp");
  }
}

TEST(SeriesWriter, LeavesNothingUntilItIsPublished) {
  const TemporaryFolder folder;
  {
    SeriesWriter writer(folder / "series");
    writer.add(0, SampleResult().result());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "series"));
}

TEST(SeriesWriter, RefusesTimesThatDoNotGrowAndASeriesOfNothing) {
  const TemporaryFolder folder;
  const SampleResult sample;
  SeriesWriter writer(folder / "series");
  EXPECT_THROW(writer.publish(), PreconditionError);
  writer.add(1, sample.result());
  EXPECT_THROW(writer.add(1, sample.result()), PreconditionError);
}

}  // namespace
}  // namespace gnomon
