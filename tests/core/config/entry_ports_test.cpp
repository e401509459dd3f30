// SPDX-License-Identifier: Apache-2.0
#include "config/entry_ports.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/support/swapped_tree.h"

namespace syncline {
namespace {

using Wiring = std::vector<std::optional<PreviousPort>>;

TEST(EntryPorts, ALineIsEnteredByPortA) {
  const Wiring line{std::nullopt, PreviousPort{0, 1}, PreviousPort{1, 1}};
  for (const auto& entry : entry_ports(line)) EXPECT_EQ(entry, 0);
}

TEST(EntryPorts, ASlaveBehindItsBranchIsEnteredByAnother) {
  // 0 has 3 at its port B; 1 hangs at port C of 3 and 2 at its port A.
  const Wiring wiring{std::nullopt, PreviousPort{3, 2}, PreviousPort{3, 0}, PreviousPort{0, 1}};
  EXPECT_EQ(entry_ports(wiring)[3], 1);
  EXPECT_EQ(entry_ports(wiring)[0], 0);
}

TEST(EntryPorts, WhatNoWiringExplainsIsSaid) {
  EXPECT_FALSE(entry_ports(Wiring{std::nullopt, PreviousPort{1, 1}})[1]) << "hangs at itself";
  EXPECT_FALSE(entry_ports(Wiring{PreviousPort{1, 1}, PreviousPort{0, 1}})[0]) << "in a circle";
  EXPECT_FALSE(entry_ports(Wiring{PreviousPort{9, 1}})[0]) << "at nobody";
  // All ports of 3 are taken, one of them in front of it: none is left to come in by.
  const Wiring full{PreviousPort{1, 3}, std::nullopt, PreviousPort{1, 0}, PreviousPort{1, 1}, PreviousPort{1, 2}};
  EXPECT_FALSE(entry_ports(full)[1]);
}

TEST(EntryPorts, EveryTreeIsExplained) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const auto tree = test::swapped_tree(40, seed);
    Wiring wiring;
    for (const auto& slave : tree) wiring.push_back(slave.previous);
    const auto entries = entry_ports(wiring);
    for (std::size_t i = 0; i < tree.size(); ++i) {
      RC_ASSERT(entries[i].has_value());
      if (tree[i].entry == 0) RC_ASSERT(entries[i] == 0);
    }
  }));
}

}  // namespace
}  // namespace syncline
