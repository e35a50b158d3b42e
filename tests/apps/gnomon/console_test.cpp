#include "apps/gnomon/console.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

TEST(ProgressText, TellsPercentAndTimeLeft) {
  EXPECT_EQ(progress_text("point", 512, 2048, -1, 4), "point 512 of 2048, 25 %, 12 s left");
  EXPECT_EQ(progress_text("receiver", 1, 3, -1, 600), "receiver 1 of 3, 33 %, 20 min left");
  EXPECT_EQ(progress_text("pair", 1, 1000, -1, 20), "pair 1 of 1000, 0 %, 5.6 h left");
}

TEST(ProgressText, TakesTheShareThatIsKnownWhereStepsAreNotCounted) {
  EXPECT_EQ(progress_text("point", 1024, 0, 0.5, 30), "point 1024, 50 %, 30 s left");
  EXPECT_EQ(progress_text("point", 1024, 0, -1, 30), "point 1024, 30 s so far");
}

TEST(ProgressText, GuessesNothingBeforeThereIsAnythingToGuessFrom) {
  EXPECT_EQ(progress_text("point", 3, 4, -1, 0.5), "point 3 of 4, 75 %");
  EXPECT_EQ(progress_text("receiver", 0, 1, -1, 40), "receiver 0 of 1, 0 %, 40 s so far");
}

}  // namespace
}  // namespace gnomon
