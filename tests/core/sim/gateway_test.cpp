// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "protocol/coe.h"
#include "protocol/mailbox.h"
#include "sim/segment/pin_trace.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

constexpr std::uint16_t kGatewayOutputs = 0x1100, kGatewayInputs = 0x1200;

/// The CAN gateway alone on the bus. Parameters are set as a device's default values.
class Gateway : public testing::Test {
 protected:
  struct Inputs {
    std::uint32_t data;
    std::uint8_t node_state, sync_messages;
  };

  /// To OP, synchronised by SYNC0 (and SYNC1 so much later) or by the outputs.
  std::uint16_t start(std::uint32_t sync1_ns = 0, bool dc = true) {
    probe.emplace(line({sim_slave("SL-6751", "can-gateway")}));
    probe->set_sync_manager(0, 0, 0x1800, 128, 0x26);
    probe->set_sync_manager(0, 1, 0x1900, 128, 0x22);
    EXPECT_EQ(probe->request(0, 2), 2);
    for (const auto& [sub_index, value] : parameters) write_object(0xF800, sub_index, le_bytes(value));
    if (delay_percent != 0) write_object(0xF800, 0x0E, {delay_percent});
    if (input_shift != 0) write_object(0x1C33, 3, le_bytes(input_shift));
    if (told_cycle != 0) write_object(0x1C32, 2, le_bytes(told_cycle));
    if (dc) {
      const auto now = probe->read(0, reg::kSystemTime, 8).value<std::uint64_t>();
      probe->write(0, reg::kSync0CycleTime, le_bytes(sync0_ns));
      probe->write(0, reg::kSync1CycleTime, le_bytes(sync1_ns));
      probe->write(0, reg::kStartTimeCyclicOperation, le_bytes(now + 5 * kMillisecond));
      probe->write(0, reg::kCyclicUnitControl, {0x00, static_cast<std::uint8_t>(sync1_ns != 0 ? 0x07 : 0x03)});
    }
    probe->set_sync_manager(0, 2, kGatewayOutputs, 4, 0x64);
    probe->set_sync_manager(0, 3, kGatewayInputs, 6, 0x20);
    if (const auto status = probe->request(0, 4); status != 4) return status;
    if (dc) probe->pass(5 * kMillisecond);  // OP needs the first SYNC0
    output(0);
    return probe->request(0, 8);
  }
  std::optional<coe::Response> sdo(const coe::Request& request) {
    MailboxMessage mail;
    mail.counter = counter = next_mailbox_counter(counter);
    mail.data = coe::encode(request);
    EXPECT_EQ(probe->write(0, 0x1800, mail.encode(128)).wkc, 1);
    probe->pass(kMillisecond);
    const auto reply = probe->read(0, 0x1900, 128);
    if (reply.wkc != 1) return std::nullopt;
    const auto answer = coe::decode_response(MailboxMessage::decode(reply.data)->data);
    return answer ? std::optional(*answer) : std::nullopt;
  }
  void write_object(std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t> value) {
    const auto size = static_cast<std::uint32_t>(value.size());
    const auto answer = sdo(coe::DownloadRequest{{index, sub_index}, false, true, size, std::move(value)});
    ASSERT_TRUE(answer && std::holds_alternative<coe::DownloadResponse>(*answer));
  }
  std::uint32_t read_object(std::uint16_t index, std::uint8_t sub_index) {
    const auto answer = sdo(coe::UploadRequest{{index, sub_index}, false});
    if (!answer || !std::holds_alternative<coe::UploadResponse>(*answer)) return 0xDEADBEEF;
    auto data = std::get<coe::UploadResponse>(*answer).data;
    data.resize(4);
    return load_le<std::uint32_t>(data);
  }
  void output(std::uint32_t value) { probe->write(0, kGatewayOutputs, le_bytes(value)); }
  Inputs inputs() {
    const auto data = probe->read(0, kGatewayInputs, 6).data;
    return {load_le<std::uint32_t>(data), data[4], data[5]};
  }
  /// So many bus cycles of 1 ms with new outputs each.
  void cycles(unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      output(i + 1);
      probe->pass(kMillisecond - 20 * kMicrosecond);
    }
  }

  /// Sub-indices of an object that the mailbox reads.
  std::vector<int> sub_indices(std::uint16_t index) {
    std::vector<int> all;
    for (int sub_index = 0; sub_index < 20; ++sub_index) {
      if (read_object(index, static_cast<std::uint8_t>(sub_index)) != 0xDEADBEEF) all.push_back(sub_index);
    }
    return all;
  }

  std::optional<SimProbe> probe;
  std::vector<std::pair<std::uint8_t, std::uint32_t>> parameters;
  std::uint32_t sync0_ns = 1'000'000;
  std::uint32_t told_cycle = 0;    // 0x1C32:02 in the start-up list
  std::uint8_t delay_percent = 0;  // 0xF800:0E, of the CAN cycle
  std::uint32_t input_shift = 0;   // 0x1C33:03
  std::uint8_t counter = 0;
};

TEST_F(Gateway, EchoesItsNodeEachSync0) {
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  const auto before = inputs().sync_messages;
  cycles(20);
  const auto after = inputs();
  EXPECT_NEAR(static_cast<std::uint8_t>(after.sync_messages - before), 20, 1);
  EXPECT_GE(after.data, 18U);
  EXPECT_EQ(after.node_state, 0);
}

TEST_F(Gateway, WithoutDcTheOutputsStartTheCanCycle) {
  ASSERT_EQ(start(0, false), 8);
  const auto before = inputs().sync_messages;
  cycles(7);
  EXPECT_EQ(static_cast<std::uint8_t>(inputs().sync_messages - before), 6) << "inputs come with the next CAN cycle";
  probe->pass(20 * kMillisecond);
  EXPECT_EQ(static_cast<std::uint8_t>(inputs().sync_messages - before), 6) << "nothing without outputs";
}

TEST_F(Gateway, TheCanCycleIsAMultipleOfTheBusCycle) {
  parameters = {{4, 4'000'000}};
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  const auto before = inputs().sync_messages;
  cycles(20);
  EXPECT_NEAR(static_cast<std::uint8_t>(inputs().sync_messages - before), 5, 1);
}

TEST_F(Gateway, ACanCycleThatFitsNoBusCycleIsRefused) {
  parameters = {{4, 1'500'000}};
  EXPECT_EQ(start(), 0x12);
  EXPECT_EQ(probe->al_code(0), 0x0026);
}

TEST_F(Gateway, ASync0FasterThanItsMinimumCycleIsRefused) {
  sync0_ns = 50'000;
  EXPECT_EQ(start(), 0x12);
  EXPECT_EQ(probe->al_code(0), 0x002E);
}

TEST_F(Gateway, ACycleTimeObjectThatContradictsSync0IsRefused) {
  told_cycle = 2'000'000;
  EXPECT_EQ(start(), 0x12);
  EXPECT_EQ(probe->al_code(0), 0x0035);
  told_cycle = sync0_ns;
  EXPECT_EQ(start(), 8);
}

TEST_F(Gateway, ABusyCanSkipsCycles) {
  parameters = {{7, 1'500'000}};
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  const auto before = inputs().sync_messages;
  cycles(20);
  EXPECT_NEAR(static_cast<std::uint8_t>(inputs().sync_messages - before), 10, 1) << "every other one was skipped";
  EXPECT_NEAR(read_object(0x1C32, 0x0C), 13, 4) << "and counted where the ESI of an EL6751 has the counter";
  EXPECT_LT(read_object(0x1C32, 0x0B), 14U) << "SYNC0s without outputs: while the test used the mailbox";
}

TEST_F(Gateway, WithoutDcTheMultiplierIsOneUntilTheMasterTellsItsCycle) {
  parameters = {{4, 4'000'000}};
  ASSERT_EQ(start(0, false), 8);
  auto before = inputs().sync_messages;
  cycles(20);
  EXPECT_NEAR(static_cast<std::uint8_t>(inputs().sync_messages - before), 20, 1);
  told_cycle = 1'000'000;
  ASSERT_EQ(start(0, false), 8);
  before = inputs().sync_messages;
  cycles(20);
  EXPECT_NEAR(static_cast<std::uint8_t>(inputs().sync_messages - before), 5, 1);
  EXPECT_EQ(read_object(0x1C32, 1), 1U);
  EXPECT_EQ(read_object(0x1C33, 1), 0x22U);
}

TEST_F(Gateway, ALongCanCycleMaySendOverSeveralBusCycles) {
  // The answer comes 2.1 ms behind the start: far too late for one bus cycle, in time for the last one of four.
  parameters = {{4, 4'000'000}, {7, 3'500'000}};
  input_shift = 200'000;
  delay_percent = 50;
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0);
  EXPECT_GE(inputs().data, 12U);
  EXPECT_EQ(read_object(0x1C32, 0x0C), 0U);
  EXPECT_EQ(read_object(0xF102, 1), 0U);
  delay_percent = 80;  // 3.2 ms: behind the input shift time of the last bus cycle
  ASSERT_EQ(start(), 8);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0x28);
  EXPECT_EQ(read_object(0xF102, 1), 0x28U);
}

TEST_F(Gateway, AsynchronousPdosNeedNoMultiplierAndNoSyncMessages) {
  parameters = {{4, 4'000'000}, {8, 1}};
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  cycles(20);
  EXPECT_EQ(inputs().sync_messages, 0);
  EXPECT_GE(inputs().data, 18U) << "each bus cycle is a CAN cycle";
}

/// Distances of the CAN SYNC messages, largest less smallest.
Nanoseconds spread(const std::vector<sim::PinEdge>& edges) {
  Nanoseconds last = 0, least = INT64_MAX, most = 0;
  for (const auto& edge : edges) {
    if (!edge.level) continue;
    if (last != 0) {
      least = std::min(least, edge.time - last);
      most = std::max(most, edge.time - last);
    }
    last = edge.time;
  }
  return most - least;
}

TEST_F(Gateway, Sync1SendsTheSyncMessageWithinHalfAMicrosecond) {
  ASSERT_EQ(start(100'000), 8);
  probe->pass(5 * kMillisecond);
  cycles(50);
  ASSERT_GT(probe->bus->pin_edges(0, 1).size(), 80U);
  EXPECT_LE(spread(probe->bus->pin_edges(0, 1)), 1000) << "0 to 500 ns each";
  EXPECT_GT(spread(probe->bus->pin_edges(0, 1)), 0);
  ASSERT_EQ(start(), 8);
  probe->pass(5 * kMillisecond);
  cycles(50);
  EXPECT_GT(spread(probe->bus->pin_edges(0, 1)), 5 * kMicrosecond) << "without SYNC1 the preparation shows";
}

TEST_F(Gateway, ASync1ThatIsTooEarlyIsCounted) {
  ASSERT_EQ(start(100'000), 8);
  cycles(20);
  EXPECT_EQ(read_object(0x1C32, 0x0D), 0U);
  ASSERT_EQ(start(20'000), 8);
  cycles(20);
  EXPECT_GE(read_object(0x1C32, 0x0D), 10U);
  EXPECT_EQ(read_object(0x1C32, 1), 2U) << "SYNC0 starts its cycle, SYNC1 releases a message";
  EXPECT_EQ(read_object(0x1C32, 0x0A), 1'000'000U);
}

TEST_F(Gateway, AnswersBehindTheInputShiftTimeAreLate) {
  delay_percent = 30;
  input_shift = 200'000;
  ASSERT_EQ(start(), 8);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0x28);
  EXPECT_EQ(inputs().data, 0U) << "the old inputs stay";
  input_shift = 500'000;
  ASSERT_EQ(start(), 8);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0);
}

TEST_F(Gateway, Sync1ReleasesTheSyncMessage) {
  // 100 us behind SYNC0 the answer needs 130 us more: too late for 200 us, in time for 300 us.
  input_shift = 200'000;
  ASSERT_EQ(start(100'000), 8);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0x28);
  input_shift = 300'000;
  ASSERT_EQ(start(100'000), 8);
  cycles(20);
  EXPECT_EQ(inputs().node_state, 0);
}

TEST_F(Gateway, SignalsThatNoOperationModeHasAreRefused) {
  auto slave = sim_slave("SL-6751", "can-gateway");
  std::erase_if(slave.device.dc->op_modes, [](const DcOpMode& mode) { return mode.assign_activate == 0x0700; });
  probe.emplace(line({slave}));
  probe->set_sync_manager(0, 0, 0x1800, 128, 0x26);
  probe->set_sync_manager(0, 1, 0x1900, 128, 0x22);
  ASSERT_EQ(probe->request(0, 2), 2);
  probe->write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
  probe->write(0, reg::kCyclicUnitControl, {0x00, 0x07});
  probe->set_sync_manager(0, 2, kGatewayOutputs, 4, 0x64);
  probe->set_sync_manager(0, 3, kGatewayInputs, 6, 0x20);
  EXPECT_EQ(probe->request(0, 4), 0x12);
  EXPECT_EQ(probe->al_code(0), 0x0030);
}

TEST_F(Gateway, HasTheParametersOfItsBus) {
  ASSERT_EQ(start(), 8);
  EXPECT_EQ(sub_indices(0xF800), (std::vector{0, 1, 2, 3, 4, 5, 7, 8, 14}));
  EXPECT_EQ(read_object(0xF800, 0), 14U);
}

}  // namespace
}  // namespace syncline::test
