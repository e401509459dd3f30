// SPDX-License-Identifier: Apache-2.0
#include "protocol/register_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "protocol/registers.h"

namespace syncline::reg {
namespace {

using Bytes = std::vector<std::uint8_t>;

const RegisterLayout& layout_of(const std::vector<RegisterLayout>& all, std::uint16_t address) {
  return *std::ranges::find(all, address, &RegisterLayout::address);
}

TEST(RegisterLayout, HasEachByteOnce) {
  const auto all = register_layouts(16, 16);
  unsigned end = 0;
  for (const auto& one : all) {
    EXPECT_GE(one.address, end) << one.name;
    EXPECT_FALSE(one.name.empty()) << one.address;
    end = one.address + one.length;
    unsigned bits = 0;
    for (const auto& field : one.fields) {
      EXPECT_GE(field.bit, bits) << one.name << ": " << field.name;
      bits = field.bit + field.width;
      EXPECT_LE(bits, 8U * one.length) << one.name << ": " << field.name;
    }
  }
  EXPECT_LT(register_layouts(3, 4).size(), all.size());
}

TEST(RegisterLayout, SaysWhatTheBitsMean) {
  const auto all = register_layouts(1, 1);
  const auto field = [&](std::uint16_t address, std::string_view name, const Bytes& bytes) {
    const auto& fields = layout_of(all, address).fields;
    return field_text(*std::ranges::find(fields, name, &RegisterField::name), bytes);
  };
  EXPECT_EQ(field(kDlStatus, "Communication port 1", {0x30, 0x08}), "yes");
  EXPECT_EQ(field(kDlStatus, "Loop port 3", {0x00, 0x40}), "closed");
  EXPECT_EQ(field(kPortDescriptor, "Port 1", {0x0B}), "EBUS");
  EXPECT_EQ(field(kAlStatus, "State", {0x14, 0x00}), "SAFEOP");
  EXPECT_EQ(field(kAlStatus, "State", {0x0F, 0x00}), "15") << "what nobody defined";
  EXPECT_EQ(field(sync_manager(0) + 4, "Direction", {0x26}), "write (outputs)");
  EXPECT_EQ(register_text(layout_of(all, kAlStatus), Bytes{0x14, 0}), "SAFEOP + ERR");
  EXPECT_EQ(register_text(layout_of(all, kSystemTimeDifference), Bytes{5, 0, 0, 0x80}), "-5 ns")
      << "bit 31 is the sign";
  EXPECT_EQ(register_text(layout_of(all, kSpeedCounterDiff), Bytes{0xFE, 0xFF}), "-2");
  EXPECT_EQ(register_text(layout_of(all, kPulseLength), Bytes{100, 0}), "1000 ns");
}

/// An ESC without a unit does not answer for it, and must not hide it behind one that it has.
TEST(RegisterRanges, StayInTheirBlocks) {
  const auto all = register_layouts(2, 2);
  std::vector<const RegisterLayout*> wanted;
  for (const auto& one : all) {
    if (one.group == RegisterGroup::kClock) wanted.push_back(&one);
  }
  const auto ranges = ranges_of(wanted);
  ASSERT_FALSE(ranges.empty());
  EXPECT_EQ(ranges.front(), (RegisterRange{0x0900, 16}));
  for (const auto& range : ranges) EXPECT_EQ(range.address / 16, (range.address + range.length - 1) / 16);
  std::set<std::uint16_t> covered;
  for (const auto& range : ranges) {
    for (unsigned i = 0; i < range.length; ++i) covered.insert(static_cast<std::uint16_t>(range.address + i));
  }
  for (const auto* one : wanted) EXPECT_TRUE(covered.contains(one->address)) << one->name;
  EXPECT_TRUE(ranges_of({}).empty());
}

/// The time of an edge is kept until somebody reads it.
TEST(RegisterRanges, LatchedTimesAreMarked) {
  for (const auto& one : register_layouts(0, 0))
    EXPECT_EQ(one.reading_matters, one.address >= 0x09B0 && one.address < 0x09D0) << one.name;
}

}  // namespace
}  // namespace syncline::reg
