// SPDX-License-Identifier: Apache-2.0
#include "record/run_session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>

#include "channels/background_master.h"
#include "channels/master_channels.h"
#include "config/network_config.h"

namespace syncline {
namespace {

using Phase = RunSession::Phase;
using Sign = RunSession::Sign;

/// Does what the test tells it; its end waits until it may.
class ToldMaster final : public BackgroundMaster {
 public:
  explicit ToldMaster(std::shared_ptr<std::atomic<bool>> may_end = {}) : may_end_(std::move(may_end)) {}
  ~ToldMaster() override {
    if (may_end_) may_end_->wait(false);
  }
  ToldMaster(const ToldMaster&) = delete;
  ToldMaster& operator=(const ToldMaster&) = delete;
  [[nodiscard]] MasterChannels& channels() override { return channels_; }
  [[nodiscard]] bool is_virtual() const override { return false; }
  void start() override { started_ = true; }
  [[nodiscard]] bool started() const override { return started_; }
  void stop() override {}
  bool step() override { return ++steps < 3; }
  void run_for(Nanoseconds) override {}
  [[nodiscard]] bool online() const override { return true; }

  int steps = 0;

 private:
  std::shared_ptr<std::atomic<bool>> may_end_;
  MasterChannels channels_;
  bool started_ = false;
};

class Session : public testing::Test {
 protected:
  void begin(bool with_thread = false) {
    auto master = std::make_unique<ToldMaster>();
    master_ = master.get();
    session_.take(std::move(master));
    EXPECT_TRUE(session_.go_online({}, AlState::kOp, {}));
    if (with_thread) session_.start();
  }
  MasterChannels& channels() { return session_.channels(); }

  RunSession session_;
  ToldMaster* master_ = nullptr;
};

TEST_F(Session, TellsTheVariablesBeforeWhatRuns) {
  session_.take(std::make_unique<ToldMaster>());
  EXPECT_EQ(session_.phase(), Phase::kOffline);
  WatchCommand watch;
  watch.count = 1;
  EXPECT_TRUE(session_.go_online({}, AlState::kSafeop, watch));
  EXPECT_EQ(session_.phase(), Phase::kStarting);
  const auto first = channels().commands.pop(), second = channels().commands.pop();
  ASSERT_TRUE(first && second);
  EXPECT_TRUE(std::holds_alternative<WatchCommand>(first->command));
  ASSERT_TRUE(std::holds_alternative<GoOnlineCommand>(second->command));
  EXPECT_EQ(std::get<GoOnlineCommand>(second->command).target, AlState::kSafeop);
}

TEST_F(Session, WithoutVariablesOnlyTellsWhatRuns) {
  begin();
  const auto first = channels().commands.pop();
  ASSERT_TRUE(first);
  EXPECT_TRUE(std::holds_alternative<GoOnlineCommand>(first->command));
  EXPECT_FALSE(channels().commands.pop());
}

/// Writes down the order.
struct Order {
  std::string told;
  void add(const std::vector<CycleSample>& samples) { told += std::to_string(samples.size()) + " samples"; }
  void add(const Event&) { told += ", event"; }
  void add(const Snapshot& snapshot) { told += ", snapshot of " + std::to_string(snapshot.time); }
};

TEST_F(Session, GivesWhatItDrainedInTheOrderInWhichARecordNeedsIt) {
  begin();
  Snapshot now;
  now.time = 7;
  channels().snapshot.publish(now);
  channels().samples.push(CycleSample{});
  channels().samples.push(CycleSample{});
  channels().events.push({3, -1, events::SlaveLost{}});
  Order order;
  session_.drain().feed(order);
  EXPECT_EQ(order.told, "2 samples, event, snapshot of 7");
  EXPECT_EQ(session_.snapshot().time, 7);
  Order nothing;
  session_.drain().feed(nothing);
  EXPECT_EQ(nothing.told, "0 samples") << "each once";
}

TEST_F(Session, FollowsWhatTheMasterTells) {
  begin();
  session_.follow({1, -1, events::SlaveLost{}});
  EXPECT_EQ(session_.phase(), Phase::kStarting);
  session_.follow({2, -1, events::Online{}});
  EXPECT_EQ(session_.phase(), Phase::kOnline);
  EXPECT_FALSE(session_.over());
  session_.follow({3, -1, events::Offline{}});
  EXPECT_TRUE(session_.over());
  EXPECT_TRUE(session_.end(std::chrono::milliseconds(0))) << "without a thread it ends at once";
  EXPECT_EQ(session_.phase(), Phase::kOffline);
  EXPECT_EQ(session_.master(), nullptr);
  begin();
  EXPECT_FALSE(session_.over()) << "of another run";
}

TEST_F(Session, AnOnlineThatComesWhileItStopsBringsItNotBack) {
  begin();
  session_.go_offline(false);
  session_.follow({2, -1, events::Online{}});
  EXPECT_EQ(session_.phase(), Phase::kStopping);
}

TEST_F(Session, BreaksOffOnlyWhereItIsTo) {
  begin();
  (void)channels().commands.pop();
  EXPECT_TRUE(session_.go_offline(false));
  EXPECT_FALSE(channels().cancel);
  EXPECT_TRUE(std::holds_alternative<GoOfflineCommand>(channels().commands.pop()->command));
  EXPECT_TRUE(session_.go_offline(true));
  EXPECT_TRUE(channels().cancel);
}

TEST_F(Session, CarriesTheWayDownOutWhereNoThreadDoes) {
  begin();
  session_.run_down();
  EXPECT_EQ(master_->steps, 3);
  session_.end({});
  begin(true);
  session_.run_down();
  EXPECT_EQ(master_->steps, 0);
}

TEST_F(Session, HearsWhetherTheMasterLives) {
  session_.set_patience({.silence = std::chrono::milliseconds(-1)});  // over when it begins
  begin(true);
  session_.follow({2, -1, events::Online{}});
  Snapshot now;
  now.time = 7;
  channels().snapshot.publish(now);
  session_.drain();
  EXPECT_EQ(session_.listen(), Sign::kSilent);
  EXPECT_EQ(session_.phase(), Phase::kSilent);
  EXPECT_EQ(session_.snapshot().time, 0) << "nothing that it told is so now";
  EXPECT_FALSE(session_.listen()) << "told once";
  ++channels().heartbeat;
  EXPECT_EQ(session_.listen(), Sign::kAlive);
  EXPECT_EQ(session_.phase(), Phase::kOnline) << "as before";
  session_.go_offline(false);
  EXPECT_FALSE(session_.listen()) << "its end has a patience of its own";
}

TEST_F(Session, NobodyHearsAMasterWithoutAThread) {
  session_.set_patience({.silence = std::chrono::milliseconds(-1)});
  begin();
  EXPECT_FALSE(session_.listen());
}

TEST_F(Session, KnowsWhenTheWayDownTakesTooLong) {
  session_.set_patience({.stop = std::chrono::milliseconds(-1)});
  begin();
  EXPECT_FALSE(session_.is_overdue());
  session_.go_offline(false);
  EXPECT_TRUE(session_.is_overdue());
  session_.set_patience({});
  EXPECT_FALSE(session_.is_overdue());
}

TEST_F(Session, LeavesAMasterThatDoesNotEndAlone) {
  const auto may_end = std::make_shared<std::atomic<bool>>(false);
  session_.take(std::make_unique<ToldMaster>(may_end));
  session_.start();
  EXPECT_FALSE(session_.end(std::chrono::milliseconds(0)));
  EXPECT_EQ(session_.phase(), Phase::kOffline);
  *may_end = true;
  may_end->notify_all();
}

}  // namespace
}  // namespace syncline
