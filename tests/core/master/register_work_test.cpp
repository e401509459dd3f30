// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/register_work.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "master/exchange/slave_address.h"
#include "protocol/registers.h"
#include "tests/core/master/terminals_bed.h"

namespace syncline {
namespace {

class RegisterWorkTest : public test::TerminalsBed {
 protected:
  RegisterWork work;
  std::vector<std::uint8_t> bytes;
};

/// A range that takes more than a datagram, over a line that loses two of them.
TEST_F(RegisterWorkTest, WhatIsWrittenIsReadBackBehindWhatIsThere) {
  constexpr std::uint16_t kMemory = 0x1800;
  std::vector<std::uint8_t> data(RegisterWork::kMost + 99);
  std::iota(data.begin(), data.end(), std::uint8_t{3});
  const auto slave = SlaveAddress::at_position(1);
  link.lose(1);
  work.write(slave, kMemory, data);
  ASSERT_TRUE(run_to_end(bus, work));
  bytes = {1, 2};
  link.lose(1);
  work.read(slave, kMemory, data.size(), bytes);
  ASSERT_TRUE(run_to_end(bus, work));
  data.insert(data.begin(), {1, 2});
  EXPECT_EQ(bytes, data);
}

TEST_F(RegisterWorkTest, ARegisterThatNobodyHasIsNamed) {
  work.read(SlaveAddress::at_position(7), reg::kAlStatus, 2, bytes);
  const auto status = run_to_end(bus, work);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kWorkingCounter);
  EXPECT_EQ(status.error().subject, "register 0x0130");
  EXPECT_TRUE(bytes.empty());
}

}  // namespace
}  // namespace syncline
