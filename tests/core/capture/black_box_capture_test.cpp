// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "capture/pcap_reader.h"
#include "support/random.h"
#include "support/text_bytes.h"
#include "support/whole_file.h"
#include "tests/support/black_box_file.h"
#include "tests/support/pcapng_file.h"

namespace syncline {
namespace {

using test::BlackBoxFile;
using test::kBegin;

/// Cut anywhere, as by a kill or a power cut in the middle of writing: our own reader has all before the cut, and
/// tells.
TEST_F(BlackBoxFile, CutAtAnyByteItIsWholeUpToThere) {
  auto box = start(options());
  Random random(5);
  for (int i = 0; i < 40; ++i) push(60 + random.next() % 200);
  box->note(kBegin + 10 * kMillisecond, "something happened");
  EXPECT_TRUE(box->finish());
  ASSERT_EQ(files().size(), 1U);
  const auto whole = *read_whole_file(files().front());
  const auto blocks = test::pcapng_blocks(bytes_of(whole));
  ASSERT_EQ(blocks.size(), 43U);
  for (std::size_t size = blocks[1].end; size < whole.size(); ++size) {
    std::size_t expected = 0;
    bool between = false;
    for (const auto& block : blocks) {
      expected += block.type == test::kPacketBlock && block.end <= size ? 1 : 0;
      between = between || block.end == size;
    }
    const auto cut = bytes_of(std::string_view(whole).substr(0, size));
    auto reader = PcapReader::from_memory(cut, "cut");
    ASSERT_TRUE(reader) << size;
    std::size_t found = 0;
    auto next = reader->next();
    for (; next && *next; next = reader->next()) {
      ASSERT_LT(found, 40U);
      EXPECT_EQ((*next)->time, kBegin + static_cast<Nanoseconds>(found) * kMillisecond);
      EXPECT_EQ((*next)->bytes, blocks[2 + found].frame);
      ++found;
    }
    EXPECT_EQ(found, expected) << size;
    EXPECT_EQ(next.has_value(), between) << size << ": a cut is told";
  }
}

}  // namespace
}  // namespace syncline
