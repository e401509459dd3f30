// SPDX-License-Identifier: Apache-2.0
// A master whose thread hangs: it is told, nothing that it said before is shown, and the window goes on.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QTimer>
#include <QUndoStack>
#include <array>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "channels/master_channels.h"
#include "compile/compile.h"
#include "engine/background_master.h"
#include "link/link.h"
#include "support/clock.h"
#include "support/ui_test_support.h"
#include "ui/main_window.h"
#include "ui/models/message_model.h"
#include "ui/models/network_model.h"
#include "ui/session/network_run.h"
#include "ui/session/workspace.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using std::chrono::milliseconds;
using Phase = NetworkRun::Phase;
using Sign = NetworkRun::Sign;

/// Where a test holds the master's thread.
struct Gate {
  void set(bool now_shut) {
    const std::scoped_lock lock(mutex);
    shut = now_shut;
    moved.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex);
    held = shut;
    moved.wait(lock, [this] { return !shut; });
    held = false;
  }
  std::mutex mutex;
  std::condition_variable moved;
  bool shut = false;
  std::atomic<bool> held{false};  // somebody stands before it
  std::atomic<int> links{0};
};

/// A driver that does not come back while the gate is shut; nobody else is on the bus.
class GatedLink final : public Link {
 public:
  explicit GatedLink(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) { ++gate_->links; }
  ~GatedLink() override { --gate_->links; }
  GatedLink(const GatedLink&) = delete;
  GatedLink& operator=(const GatedLink&) = delete;
  Status send(std::span<const std::uint8_t>) override {
    gate_->pass();
    return {};
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t>, Nanoseconds deadline) override {
    clock_.sleep_until(deadline);
    gate_->pass();
    return ReceivedFrame{};
  }
  [[nodiscard]] LinkDescription describe() const override { return {.name = "gate", .kind = "test", .up = true}; }

 private:
  std::shared_ptr<Gate> gate_;
  RealClock clock_;
};

class SilentMaster : public testing::Test {
 protected:
  SilentMaster()
      : run_([this](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
          return make_background_master({std::make_unique<RealClock>(), std::make_unique<GatedLink>(gate_), {}});
        }) {
    run_.setPatience({milliseconds(100), milliseconds(100)});
    QObject::connect(&run_, &NetworkRun::signSeen, &run_, [this](Sign sign) { signs_.push_back(sign); });
  }
  ~SilentMaster() override {
    gate_->set(false);
    run_.shutDown();
    EXPECT_TRUE(test::waitFor([this] { return gate_->links == 0; })) << "what was left alone ends when it can";
  }
  static RunOrigin origin() {
    const auto project = test::smallProject();
    return {project, {}, compile(project).value().config};
  }
  /// A command that needs the bus, on which the thread then hangs.
  void hang() {
    gate_->set(true);
    ASSERT_TRUE(run_.goOnline(QStringLiteral("nic:gate"), origin()));
    // On a busy host it is silent before it comes to the gate, and then ends in order.
    ASSERT_TRUE(test::waitFor([this] { return run_.phase() == Phase::kSilent && gate_->held; }));
  }

  std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
  NetworkRun run_;
  std::vector<Sign> signs_;
};

TEST_F(SilentMaster, IsToldOnceAndComesBack) {
  hang();
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(signs_, std::vector{Sign::kSilent});
  EXPECT_FALSE(run_.snapshot().online);
  gate_->set(false);
  ASSERT_TRUE(test::waitFor([this] { return run_.phase() != Phase::kSilent; }));
  EXPECT_EQ(signs_, (std::vector{Sign::kSilent, Sign::kAlive}));
}

TEST_F(SilentMaster, DoesNotHoldWhoGoesOffline) {
  hang();
  ASSERT_FALSE(HasFatalFailure());
  QElapsedTimer timer;
  timer.start();
  run_.goOffline();
  EXPECT_EQ(run_.phase(), Phase::kStopping);
  ASSERT_TRUE(test::waitFor([this] { return run_.phase() == Phase::kOffline; }));
  EXPECT_LT(timer.elapsed(), test::kPatienceMs / 2);
  EXPECT_TRUE(run_.givenUp());
  EXPECT_EQ(signs_, (std::vector{Sign::kSilent, Sign::kGivenUp}));
  EXPECT_EQ(gate_->links, 1) << "it is kept as long as its thread uses it";
}

TEST_F(SilentMaster, DoesNotHoldWhoCloses) {
  hang();
  ASSERT_FALSE(HasFatalFailure());
  run_.shutDown();
  EXPECT_EQ(run_.phase(), Phase::kOffline);
  EXPECT_TRUE(run_.givenUp());
}

TEST_F(SilentMaster, IsNoneThatEndsInTime) {
  ASSERT_TRUE(run_.goOnline(QStringLiteral("nic:gate"), origin()));
  run_.setPatience({milliseconds(100), milliseconds(test::kPatienceMs)});
  run_.shutDown();
  EXPECT_FALSE(run_.givenUp());
  EXPECT_EQ(gate_->links, 0);
}

/// Told everything once, and nothing after that. Its thread is somebody else's thought.
class StuckMaster final : public BackgroundMaster {
 public:
  explicit StuckMaster(std::size_t slaves) {
    channels_.events.push({0, -1, events::Online{}});
    Snapshot snapshot;
    snapshot.online = snapshot.link_up = true;
    snapshot.state = snapshot.requested = AlState::kOp;
    snapshot.slaves.resize(slaves);
    for (auto& slave : snapshot.slaves) {
      slave.present = true;
      slave.al_status = static_cast<std::uint16_t>(AlState::kOp);
    }
    snapshot.dc.enabled = true;
    snapshot.dc.state = SyncState::kInSync;
    channels_.snapshot.publish_first(snapshot);
  }
  [[nodiscard]] MasterChannels& channels() override { return channels_; }
  [[nodiscard]] bool is_virtual() const override { return false; }
  void start() override {}
  [[nodiscard]] bool started() const override { return true; }
  void stop() override {}
  bool step() override { return false; }
  void run_for(Nanoseconds) override {}
  [[nodiscard]] bool online() const override { return true; }

 private:
  MasterChannels channels_;
};

TEST(SilentMachine, ShowsNoValueThatItHadBefore) {
  auto environment = test::virtualEnvironment();
  environment.open_master = [](const QString&, const Project& machine) -> Result<std::unique_ptr<BackgroundMaster>> {
    return std::make_unique<StuckMaster>(machine.slaves.size());
  };
  Workspace workspace(environment);
  MainWindow window(workspace);
  workspace.document().replace(QStringLiteral("load"), test::smallProject());
  workspace.setLink(QStringLiteral("nic:stuck"));
  window.show();
  workspace.live().run().setPatience({milliseconds(300), milliseconds(100)});
  const auto project = workspace.document().project();
  ASSERT_TRUE(workspace.live().goOnline(workspace.link(), {project, {}, compile(project).value().config}));
  const auto& dc = *test::find<Pill>(window, "statusDc");
  ASSERT_TRUE(test::waitFor([&] { return dc.text().contains(QStringLiteral("in sync"), Qt::CaseInsensitive); }));
  ASSERT_TRUE(test::waitFor([&] { return workspace.live().phase() == Phase::kSilent; }));
  EXPECT_FALSE(dc.text().contains(QStringLiteral("in sync"), Qt::CaseInsensitive)) << dc.text().toStdString();
  EXPECT_EQ(test::find<Pill>(window, "statusPhase")->text(), QStringLiteral("No answer"));
  const auto& network = workspace.network();
  const auto first = network.index(0, 0, network.index(0, 0));
  EXPECT_FALSE(first.data(NetworkModel::kStateRole).toInt() == static_cast<int>(AlState::kOp));
  int told = 0;
  for (int row = 0; row < workspace.messages().rowCount(); ++row)
    told += workspace.messages().message(row).text.contains(QStringLiteral("no sign of life")) ? 1 : 0;
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(test::find<QAction>(window, "actionOffline")->isEnabled());
  workspace.runs().shutDown();
  workspace.document().undoStack().setClean();
}

}  // namespace
}  // namespace syncline::ui
