// SPDX-License-Identifier: Apache-2.0
#include "support/distinct_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class DistinctFiles : public testing::Test {
 protected:
  DistinctFiles() {
    std::ofstream(file("a")) << "content";
    std::ofstream(file("b")) << "content";
    fs::create_directory(file("below"));
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder.file(name); }
  test::TemporaryFolder folder;
};

TEST_F(DistinctFiles, OneFileHasManyNames) {
  fs::create_symlink("a", file("link"));
  fs::create_symlink(file("link"), file("below/link"));
  fs::create_hard_link(file("a"), file("hard"));
  fs::create_directory_symlink(folder.path(), file("below/up"));
  for (const std::string name : {"a", "./a", "below/../a", "link", "below/link", "hard", "below/up/a"}) {
    EXPECT_TRUE(is_same_file(file("a"), file(name))) << name;
    EXPECT_TRUE(is_same_file(file(name), file("a"))) << name;
    EXPECT_FALSE(is_same_file(file(name), file("b"))) << name;
  }
}

TEST_F(DistinctFiles, ANameThatIsNotThereYetIsOneInItsFolder) {
  fs::create_symlink("new", file("dangling"));
  fs::create_directory_symlink(".", file("here"));
  for (const std::string name : {"new", "./new", "below/../new", "here/new", "dangling"}) {
    EXPECT_TRUE(is_same_file(file("new"), file(name))) << name;
  }
  EXPECT_FALSE(is_same_file(file("new"), file("newer")));
  EXPECT_FALSE(is_same_file(file("new"), file("below/new")));
  EXPECT_FALSE(is_same_file(file("new"), file("a")));
  EXPECT_FALSE(is_same_file(file("no/folder"), file("no/folder"))) << "nothing can be written there";
}

TEST_F(DistinctFiles, WhatTakesNoHarmMayBeNamedTwice) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  for (const auto& name : {std::string("/dev/null"), std::string("/dev/stdout"), std::string(), file("pipe")}) {
    EXPECT_FALSE(is_same_file(name, name)) << name;
  }
}

TEST_F(DistinctFiles, TheErrorNamesBothAndWhatToDo) {
  const std::vector<NamedFile> read{{"the argument file", file("a")}};
  const std::vector<NamedFile> apart{{"--csv", file("b")}, {"--log", file("c")}, {"--more", ""}, {"--most", ""}};
  EXPECT_TRUE(check_distinct(read, apart));
  const std::vector<NamedFile> onto{{"--csv", file("./a")}};
  const auto lost = check_distinct(read, onto);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, ErrorCode::kBadValue);
  EXPECT_EQ(lost.error().subject, "--csv");
  EXPECT_THAT(lost.error().detail.text(), HasSubstr("is what the argument file reads"));
  const std::vector<NamedFile> both{{"--csv", file("c")}, {"--log", file("./c")}};
  const auto twice = check_distinct(read, both);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().subject, "--log");
  EXPECT_THAT(twice.error().detail.text(), HasSubstr("--csv writes the file"));
}

}  // namespace
}  // namespace syncline
