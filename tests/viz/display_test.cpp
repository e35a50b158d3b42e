#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "viz/picture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Another DISPLAY while a test runs.
class Display : public testing::Test {
 protected:
  Display() {
    if (const char* before = std::getenv("DISPLAY")) before_ = before;
  }
  ~Display() override { before_ ? ::setenv("DISPLAY", before_->c_str(), 1) : ::unsetenv("DISPLAY"); }

  void expect_refused() {
    const SampleResult sample;
    const TemporaryFolder folder;
    EXPECT_THAT([&] { render_scene(sample.result(), folder / "picture.png"); },
                ThrowsMessage<NoDisplayError>(
                    AllOf(HasSubstr("no display"), HasSubstr("xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\""))));
    EXPECT_THROW(render_result(folder.path(), folder / "picture.png"), NoDisplayError);
    EXPECT_FALSE(std::filesystem::exists(folder / "picture.png"));
  }

 private:
  std::optional<std::string> before_;
};

TEST_F(Display, ThatIsMissingIsSaidToBeMissing) {
  ::unsetenv("DISPLAY");
  expect_refused();
}

TEST_F(Display, ThatIsEmptyIsSaidToBeMissing) {
  ::setenv("DISPLAY", "", 1);
  expect_refused();
}

TEST_F(Display, ThatDoesNotAnswerIsSaidToBeMissing) {
  ::setenv("DISPLAY", ":98765", 1);
  expect_refused();
}

}  // namespace
}  // namespace gnomon
