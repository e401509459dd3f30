// SPDX-License-Identifier: Apache-2.0
#include "app/composition/link_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(LinkText, ReadsTheThreeForms) {
  EXPECT_EQ(parse_link_text("sim:a/b.toml").value(), (LinkText{LinkKind::kSimulated, "a/b.toml", false, {}}));
  EXPECT_EQ(parse_link_text("nic:eth0").value(), (LinkText{LinkKind::kAdapter, "eth0", false, {}}));
  EXPECT_EQ(parse_link_text("replay:x.pcapng").value(), (LinkText{LinkKind::kReplay, "x.pcapng", false, {}}));
}

TEST(LinkText, TakesClockAndSeedInAnyOrder) {
  const LinkText wanted{LinkKind::kSimulated, "m.toml", true, 7};
  EXPECT_EQ(parse_link_text("sim:m.toml?virtual&seed=7").value(), wanted);
  EXPECT_EQ(parse_link_text("sim:m.toml?seed=7&virtual").value(), wanted);
}

TEST(LinkText, SaysWhatIsAccepted) {
  for (const char* text :
       {"", "eth0", "sim:", "tcp:host", "sim:m.toml?fast", "sim:m.toml?seed=", "sim:m.toml?seed=1x"}) {
    const auto link = parse_link_text(text);
    ASSERT_FALSE(link) << text;
    EXPECT_EQ(link.error().code, ErrorCode::kBadValue) << text;
    EXPECT_THAT(link.error().detail.text(), testing::HasSubstr("nic:NAME")) << text;
  }
}

}  // namespace
}  // namespace syncline
