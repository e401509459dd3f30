// SPDX-License-Identifier: Apache-2.0
// Two masters on one bus, turn by turn: the second one says what it found, the first one who it was not.
#include <gtest/gtest.h>

#include <algorithm>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/events/state_events.h"
#include "channels/master_channels.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/run_codes.h"
#include "master/master_service.h"
#include "tests/support/small_machines.h"
#include "trace/run_report.h"

namespace syncline {
namespace {

/// A bus that another master has, too.
class SharedLink final : public Link {
 public:
  explicit SharedLink(Link& shared) : shared_(shared) {}
  Status send(std::span<const std::uint8_t> frame) override { return shared_.send(frame); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return shared_.receive(buffer, deadline);
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return shared_.sent_at(); }
  [[nodiscard]] LinkDescription describe() const override { return shared_.describe(); }

 private:
  Link& shared_;
};

class Master {
 public:
  Master(Link& link, Clock& clock, const NetworkConfig& config, AlState target)
      : service_(std::make_unique<SharedLink>(link), clock), recorder_(config) {
    service_.channels().commands.push(GoOnlineCommand{config, target});
  }
  void run_for(Nanoseconds time) {
    service_.run_for(time);
    for (auto& event : service_.channels().events.drain()) {
      recorder_.add(event);
      events.push_back(std::move(event));
    }
    std::vector<CycleSample> samples;
    service_.channels().samples.pop(samples);
    recorder_.add(samples);
    if (service_.channels().snapshot.read(snapshot)) recorder_.add(snapshot);
  }
  template <class What>
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::ranges::count_if(events, [](const Event& e) { return e.is<What>(); }));
  }
  [[nodiscard]] std::vector<Finding> findings() const { return diagnose(recorder_.finish(snapshot)); }

  std::vector<Event> events;
  Snapshot snapshot;

 private:
  MasterService service_;
  RunRecorder recorder_;
};

TEST(TwoMasters, AreTold) {
  VirtualClock clock;
  const auto network = test::two_axes();
  const auto config = network.compiled();
  const auto link = network.link(clock);
  Master first(*link, clock, config, AlState::kOp), second(*link, clock, config, AlState::kInit);
  first.run_for(6 * kSecond);
  ASSERT_EQ(first.snapshot.state, AlState::kOp);
  EXPECT_EQ(first.count<events::BusWasRunning>(), 0U);
  EXPECT_EQ(first.count<events::LeftUnasked>(), 0U) << "what it does itself it has asked for";
  second.run_for(100 * kMillisecond);
  EXPECT_EQ(second.count<events::BusWasRunning>(), 1U);
  EXPECT_TRUE(std::ranges::none_of(second.events, [](const Event& e) {
    return e.is<events::BusWasRunning>() && e.slave >= 0;
  })) << "of nobody alone";
  for (int i = 0; i < 10; ++i) first.run_for(100 * kMillisecond);
  EXPECT_EQ(first.count<events::LeftUnasked>(), 3U);
  const auto found = first.findings();
  EXPECT_TRUE(std::ranges::any_of(found, [](const Finding& f) { return f.code == code::kSlaveLeftUnasked; }));
  for (const auto code : {code::kDriftTooHigh, code::kDcmError, code::kMasterNotLocked, code::kSlaveLeftWindow})
    EXPECT_EQ(std::ranges::count(found, code, &Finding::code), 0) << code;
}

}  // namespace
}  // namespace syncline
