// SPDX-License-Identifier: Apache-2.0
#include "trace/setpoint_slips.h"

#include <gtest/gtest.h>

#include <array>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "tests/support/small_machines.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

constexpr std::size_t kSlippingDrive = 1;

/// Two axes whose frames are lost, and sent behind a SYNC0, at known times.
class SlippingMachine {
 public:
  static constexpr int kLost = 7, kLate = 9;

  SlippingMachine() : network_(test::two_axes()) {
    // A cycle whose time is half over would be left out.
    network_.project.master.dc.dcm.set_value = 300 * kMicrosecond;
    for (int i = 0; i < kLost; ++i) {
      FaultConfig loss;
      loss.kind = FaultKind::kLoseFrames;
      loss.at = 6 * kSecond + i * 110 * kMillisecond;
      loss.count = 1;
      network_.sim.faults.push_back(loss);
    }
    config_ = network_.compiled();
    slips_.emplace(sync0_slaves(config_), config_.cycle_time());
    service_ = std::make_unique<MasterService>(network_.link(clock_), clock_);
    service_->channels().commands.push(GoOnlineCommand{config_, AlState::kOp});
  }
  void run_for(Nanoseconds time) {
    for (const auto end = clock_.now() + time; clock_.now() < end;) {
      service_->run_for(100 * kMillisecond);
      std::vector<CycleSample> samples;
      service_->channels().samples.pop(samples);
      for (const auto& sample : samples) {
        (void)slips_->observe(sample);
        left_out_ += sample.skipped_cycles;
        if ((sample.flags & CycleSample::kReferenceValid) != 0) last_ = sample;
      }
      if (service_->channels().snapshot.read(snapshot_)) (void)slips_->observe(snapshot_);
    }
  }
  /// The next frames but one stand still until they come `behind` SYNC0.
  void make_late(Nanoseconds behind) {
    const auto came = dc::outputs_arrival(last_.reference_time, snapshot_.slaves[kSlippingDrive].propagation_delay_ns,
                                          sync0_slaves(config_)[kSlippingDrive].wire);
    const auto drive = sync0_slaves(config_)[kSlippingDrive];
    const auto margin = dc::sync0_arrival({last_.sync_base + drive.shift, drive.period}, came).margin;
    const auto begin = last_.send_time + 20 * config_.cycle_time() - 50 * kMicrosecond;
    clock_.add_standstill(begin, 50 * kMicrosecond + margin + behind);
  }
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
  /// Read from the drive a while after the last disturbance.
  [[nodiscard]] std::uint32_t counted_by_drive() const { return snapshot_.slaves[kSlippingDrive].sm2_missed.value; }
  [[nodiscard]] std::optional<SetpointSlips::Count> counted() const { return slips_->count(kSlippingDrive); }

 private:
  test::SimulatedNetwork network_;
  NetworkConfig config_;
  VirtualClock clock_;
  std::optional<SetpointSlips> slips_;
  std::unique_ptr<MasterService> service_;
  CycleSample last_;
  std::uint64_t left_out_ = 0;
  Snapshot snapshot_;
};

/// The drive counts SYNC0 periods without an SM2 event. A frame that comes behind its SYNC0 leaves one empty, and
/// crowds the next one.
TEST(SetpointSlipsOnBus, AreThoseThatTheDriveCounted) {
  SlippingMachine machine;
  machine.run_for(5 * kSecond);
  const auto before = machine.counted();
  const auto drive_before = machine.counted_by_drive();
  ASSERT_TRUE(before);
  machine.run_for(2 * kSecond);
  ASSERT_TRUE(machine.counted());
  EXPECT_EQ(machine.counted()->empty - before->empty, std::uint32_t{SlippingMachine::kLost});
  EXPECT_EQ(machine.counted()->crowded, before->crowded) << "nothing was late";
  for (int i = 0; i < SlippingMachine::kLate; ++i) {
    machine.make_late((10 + 13 * i) * kMicrosecond);
    machine.run_for(100 * kMillisecond);
  }
  machine.run_for(3 * kSecond);
  ASSERT_TRUE(machine.counted());
  EXPECT_EQ(machine.left_out(), 0U) << "late frames, but one in each cycle";
  EXPECT_EQ(machine.counted()->crowded - before->crowded, std::uint32_t{SlippingMachine::kLate});
  EXPECT_EQ(machine.counted()->empty - before->empty, machine.counted_by_drive() - drive_before);
  EXPECT_EQ(machine.counted_by_drive() - drive_before, std::uint32_t{SlippingMachine::kLost + SlippingMachine::kLate});
}

}  // namespace
}  // namespace syncline
