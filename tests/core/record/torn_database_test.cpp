// SPDX-License-Identifier: Apache-2.0
#include "sqlite/torn_database.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "support/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

constexpr std::size_t kPage = 512, kPages = 2000;

void put(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<char>(value >> 8 * (count - 1 - i));
}

/// Nearly every page is a leaf whose cells are one row, as long as the file, which goes on in the second page, and from
/// there in that page again: to follow each is to read hundreds of millions of pages.
std::string rowsWithoutEnd() {
  constexpr std::size_t kCells = 90, kCell = 220, kHere = 256;
  constexpr std::uint64_t kSize = 0xBD'84'40;  // 1,000,000, seven bits a byte
  std::string bytes(kPage * kPages, '\0');
  bytes.replace(0, 15, "SQLite format 3");
  put(bytes, 16, kPage, 2);
  put(bytes, kPage, 2, 4);
  for (std::size_t begin = 2 * kPage; begin < bytes.size(); begin += kPage) {
    bytes[begin] = 0x0D;
    put(bytes, begin + 3, kCells, 2);
    for (std::size_t cell = 0; cell < kCells; ++cell) put(bytes, begin + 8 + 2 * cell, kCell, 2);
    put(bytes, begin + kCell, kSize, 3);
    put(bytes, begin + kCell + 3, 1, 1);
    put(bytes, begin + kCell + 4 + kHere, 2, 4);
  }
  return bytes;
}

TEST(TornDatabaseTest, ChainsThatGoRoundEndWithTheFile) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("round.sqlite");
  ASSERT_TRUE(write_whole_file(path, rowsWithoutEnd()).has_value());
  auto torn = TornDatabase::open(path);
  ASSERT_TRUE(torn.has_value());
  int rows = 0;
  torn->rows([&rows](std::int64_t, std::span<const TornValue>) { return ++rows > 0; });
  EXPECT_EQ(rows, 0);
}

}  // namespace
}  // namespace syncline
