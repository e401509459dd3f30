// SPDX-License-Identifier: Apache-2.0
#include "support/paths_in.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

TEST(PathsIn, IsWhatLiesThereAndWhyItCannotBeRead) {
  const test::TemporaryFolder folder;
  const fs::path root = folder.file("");
  auto error = std::make_error_code(std::errc::io_error);
  EXPECT_TRUE(paths_in(root, error).empty());
  EXPECT_FALSE(error);
  fs::create_directories(root / "below");
  std::ofstream(root / ".hidden") << 'x';
  std::ofstream(root / "below" / "deeper") << 'x';
  fs::create_symlink("nowhere", root / "link");
  EXPECT_THAT(paths_in(root, error), UnorderedElementsAre(root / "below", root / ".hidden", root / "link"));
  EXPECT_FALSE(error);
  EXPECT_TRUE(paths_in(root / "missing", error).empty());
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  EXPECT_TRUE(paths_in(root / ".hidden", error).empty());
  EXPECT_EQ(error, std::errc::not_a_directory);
}

}  // namespace
}  // namespace syncline
