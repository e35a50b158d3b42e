#include "viz/vtk/file_name.h"

#include <gtest/gtest.h>

namespace gnomon::viz {
namespace {

TEST(FileName, KeepsPlainNames) {
  EXPECT_EQ(file_name("lamp_1-b.c"), "lamp_1-b.c");
}

TEST(FileName, EncodesWhatAFolderOrAShellWouldTakeAmiss) {
  EXPECT_EQ(file_name("vase#12"), "vase%2312");
  EXPECT_EQ(file_name("a/b c"), "a%2Fb%20c");
  EXPECT_EQ(file_name("50%"), "50%25");
  EXPECT_EQ(file_name("ü"), "%C3%BC");
}

TEST(FileName, IsNeverHiddenNorAFolderAbove) {
  EXPECT_EQ(file_name(".."), "%2E.");
  EXPECT_EQ(file_name("."), "%2E");
  EXPECT_EQ(file_name(""), "%");
}

TEST(FileName, IsShortAndDiffersForLongNamesThatDifferAtTheEnd) {
  const std::string one = file_name(std::string(1000, 'a') + "1");
  const std::string two = file_name(std::string(1000, 'a') + "2");
  EXPECT_LE(one.size(), 200u);
  EXPECT_NE(one, two);
}

}  // namespace
}  // namespace gnomon::viz
