// SPDX-License-Identifier: Apache-2.0
#include "support/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace syncline {
namespace {

/// Flags of the mapping in which an address lies, as the system tells them.
std::string flags_at(const void* address) {
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream words(line);
    std::uintptr_t from = 0, to = 0;
    char dash = 0;
    if (words >> std::hex >> from >> dash >> to && dash == '-') here = from <= place && place < to;
    if (here && line.starts_with("VmFlags:")) return line + ' ';
  }
  return {};
}

TEST(LargePages, AreAskedForWhereThereIsRoomForOne) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "the system has none";
  std::vector<std::uint8_t> much;
  much.reserve(16U << 20);
  use_large_pages(much.data(), much.capacity());
  EXPECT_NE(flags_at(much.data() + much.capacity() / 2).find(" hg "), std::string::npos);
}

TEST(LargePages, LeaveWhatIsThereAndWhatIsShort) {
  std::vector<std::uint8_t> some(8U << 20, 7);
  use_large_pages(some.data(), some.size());
  EXPECT_EQ(some, std::vector<std::uint8_t>(8U << 20, 7));
  use_large_pages(some.data(), 100);
  use_large_pages(nullptr, 0);
}

}  // namespace
}  // namespace syncline
