#include "viz/pictures/display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "gnomon/picture.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// An environment variable with another value while this object lives.
class Variable {
 public:
  explicit Variable(const char* name) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// Another DISPLAY while a test runs, and no Xvfb to be found.
class DisplayWithoutXvfb : public testing::Test {
 protected:
  DisplayWithoutXvfb() : display_("DISPLAY"), path_("PATH") { ::setenv("PATH", folder_.path().c_str(), 1); }

  void expect_refused(const std::string& why) {
    const SampleResult sample;
    EXPECT_THAT([&] { render_scene(sample.result(), folder_ / "picture.png"); },
                ThrowsMessage<NoDisplayError>(AllOf(HasSubstr("no display"), HasSubstr(why),
                                                    HasSubstr("Xvfb, which makes a virtual one, is not installed"),
                                                    HasSubstr("apt-get install xvfb libgl1-mesa-dri"))));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "picture.png"));
  }

 private:
  TemporaryFolder folder_;
  Variable display_;
  Variable path_;
};

TEST_F(DisplayWithoutXvfb, ThatIsMissingIsSaidToBeMissing) {
  ::unsetenv("DISPLAY");
  expect_refused("DISPLAY is not set");
}

TEST_F(DisplayWithoutXvfb, ThatIsEmptyIsSaidToBeMissing) {
  ::setenv("DISPLAY", "", 1);
  expect_refused("DISPLAY is not set");
}

TEST_F(DisplayWithoutXvfb, ThatDoesNotAnswerIsSaidToBeMissing) {
  ::setenv("DISPLAY", ":98765", 1);
  expect_refused("nothing answers at DISPLAY=:98765");
}

TEST(VirtualDisplay, ThatDoesNotStartIsSaidNotTo) {
  const TemporaryFolder folder;
  const Variable display("DISPLAY");
  const Variable path("PATH");
  write_file(folder / "Xvfb", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(folder / "Xvfb", std::filesystem::perms::owner_all);
  ::unsetenv("DISPLAY");
  ::setenv("PATH", folder.path().c_str(), 1);
  EXPECT_THAT([] { const viz::Display none; }, ThrowsMessage<NoDisplayError>(HasSubstr("Xvfb does not start")));
}

}  // namespace
}  // namespace gnomon
