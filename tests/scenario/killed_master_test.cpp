// SPDX-License-Identifier: Apache-2.0
// The program on one end of a veth pair, the simulated segment on the other: whatever ends the program, the slaves are
// left in order, and an EEPROM holds the old content or the new one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "engine/eeprom_journal.h"
#include "protocol/al_state.h"
#include "support/random.h"
#include "support/whole_file.h"
#include "tests/app/cli_process.h"
#include "tests/app/cli_runner.h"
#include "tests/scenario/served_bus.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

/// One of each kind: that all of them are heard alike is a test of core/support.
const std::array kKinds{SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE, SIGUSR1, SIGABRT, SIGSEGV, SIGRTMAX};

const std::string kMachine = source_dir() + "/resources/demo/machine.toml";
const std::string kMasterLink = std::string("nic:") + NetNamespace::kMasterEnd;

class KilledMaster : public testing::Test {
 protected:
  void SetUp() override {
    if (!network_.ready()) GTEST_SKIP() << "no permission to create a network namespace with a veth pair";
    ::setenv("XDG_STATE_HOME", folder_.file("state").c_str(), 1);
  }
  void TearDown() override { ::unsetenv("XDG_STATE_HOME"); }

  static void expect_all_in_init(const Result<SimulateReport>& report) {
    ASSERT_TRUE(report);
    ASSERT_FALSE(report->al_status.empty());
    for (std::size_t i = 0; i < report->al_status.size(); ++i) {
      EXPECT_EQ(al_state_of(report->al_status[i]), AlState::kInit) << "slave " << i;
    }
  }
  std::string project() {
    const auto file = folder_.file("m.syncline");
    EXPECT_EQ(cli_run({"project", "create", file, "--scan", "sim:" + kMachine + "?virtual", "--cycle", "4000"}).code,
              cli::kDone);
    return file;
  }

  NetNamespace network_;
  TemporaryFolder folder_;
};

TEST_F(KilledMaster, EverySignalTakesTheSlavesToInitAndPrintsTheReport) {
  const auto file = project();
  for (const int number : kKinds) {
    ServedBus bus(kMachine);
    CliProcess run({"run", file, "--link", kMasterLink, "--for", "60s"});
    ASSERT_TRUE(run.wait_for_err("online")) << run.err();
    run.signal(number);
    const int code = run.wait();
    EXPECT_LE(code, 1) << "signal " << number << ": " << run.err();
    EXPECT_THAT(run.out(), HasSubstr("cycles")) << "signal " << number;
    expect_all_in_init(bus.finish());
  }
}

TEST_F(KilledMaster, CtrlZIsRefusedAndTheCycleGoesOn) {
  const auto file = project();
  ServedBus bus(kMachine);
  CliProcess run({"run", file, "--link", kMasterLink, "--for", "60s"});
  ASSERT_TRUE(run.wait_for_err("online")) << run.err();
  run.signal(SIGTSTP);
  ASSERT_TRUE(run.wait_for_err("not stopped"));
  for (const int number : {SIGTTIN, SIGTTOU, SIGCONT, SIGWINCH, SIGURG, SIGCHLD}) run.signal(number);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_NE(run.state(), 'T');
  run.signal(SIGINT);
  EXPECT_LE(run.wait(), 1) << run.err();
  EXPECT_THAT(run.out(), HasSubstr("cycles"));
  EXPECT_THAT(run.out(), testing::Not(HasSubstr("left OP")));
  expect_all_in_init(bus.finish());
}

TEST_F(KilledMaster, AReaderThatIsGoneEndsTheRunInOrder) {
  const auto file = project();
  ServedBus bus(kMachine);
  CliProcess run({"run", file, "--link", kMasterLink, "--for", "60s", "--every-event"});
  ASSERT_TRUE(run.wait_for_err("PREOP"));
  run.close_err();  // as "2>&1 | head" does
  EXPECT_LE(run.wait(), 3);
  expect_all_in_init(bus.finish());
}

TEST_F(KilledMaster, ASlaveInBootComesBack) {
  std::ofstream(folder_.file("firmware")) << std::string(200'000, 'f');
  for (const int number : {SIGHUP, SIGTERM}) {
    ServedBus bus(kMachine);
    CliProcess foe({"foe", "write", kMasterLink, "3", "firmware", folder_.file("firmware"), "--boot"});
    ASSERT_TRUE(foe.wait_for_err("BOOT")) << foe.err();
    foe.signal(number);
    EXPECT_EQ(foe.wait(), cli::kFailed) << foe.err();
    expect_all_in_init(bus.finish());
  }
}

class KilledEepromWrite : public KilledMaster {
 protected:
  void SetUp() override {
    KilledMaster::SetUp();
    if (IsSkipped()) return;
    scenario_ = folder_.file("slow.toml");
    std::ofstream(scenario_) << "[[slave]]\nesi = \"" << source_dir()
                             << "/resources/esi/SL-SV7.xml\"\nsii_write_ms = 2\n";
    bus_ = std::make_unique<ServedBus>(scenario_);
    old_ = read();
    new_ = old_;
    for (std::size_t i = 0x80; i < 0x180; ++i) new_[i] = static_cast<char>(new_[i] ^ 0x5A);
    std::ofstream(folder_.file("new"), std::ios::binary) << new_;
    std::ofstream(folder_.file("old"), std::ios::binary) << old_;
  }
  std::string read() {
    const auto file = folder_.file("now");
    const auto run = cli_run({"sii", "read", kMasterLink, "0", file});
    EXPECT_EQ(run.code, cli::kDone) << run.err;
    return read_whole_file(file).value_or("");
  }
  /// Kills a write so long after its first word: how long a program takes until then is the machine's affair.
  void kill_after(std::chrono::microseconds delay, int number) {
    CliProcess write({"sii", "write", kMasterLink, "0", folder_.file("new")});
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (pending_journals().empty() && std::chrono::steady_clock::now() < patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_FALSE(pending_journals().empty()) << "never began to write: " << write.err();
    std::this_thread::sleep_for(delay);
    write.signal(number);
    (void)write.wait();
  }
  std::string scenario_, old_, new_;
  std::unique_ptr<ServedBus> bus_;
};

TEST_F(KilledEepromWrite, ASignalLeavesTheOldContentOrTheNewOne) {
  Random random(5);
  int taken_back = 0;
  for (int i = 0; i < 10; ++i) {
    kill_after(std::chrono::microseconds(random.next() % 300'000), kKinds[static_cast<std::size_t>(i) % kKinds.size()]);
    const auto now = read();
    ASSERT_TRUE(now == old_ || now == new_) << "kill " << i;
    EXPECT_THAT(cli_run({"adapters"}).err, testing::Not(HasSubstr("cut short"))) << "no journal is left";
    taken_back += now == old_ ? 1 : 0;
    if (now == new_) {
      ASSERT_EQ(cli_run({"sii", "write", kMasterLink, "0", folder_.file("old")}).code, cli::kDone);
    }
  }
  EXPECT_GT(taken_back, 2);
}

TEST_F(KilledEepromWrite, WhatAKillLeavesTheNextStartFinishesOrTakesBack) {
  int torn = 0;
  for (const bool undo : {false, true, false, true}) {
    kill_after(std::chrono::milliseconds(60), SIGKILL);
    const auto now = read();
    if (now == old_) continue;
    ++torn;
    EXPECT_THAT(cli_run({"adapters"}).err,
                testing::AllOf(HasSubstr("cut short"), HasSubstr("sii finish " + kMasterLink + " 0")));
    std::vector<std::string> arguments{"sii", "finish", kMasterLink, "0"};
    if (undo) arguments.emplace_back("--undo");
    const auto finish = cli_run(arguments);
    EXPECT_EQ(finish.code, cli::kDone) << finish.err;
    EXPECT_EQ(read(), undo ? old_ : new_);
    EXPECT_THAT(cli_run({"adapters"}).err, testing::Not(HasSubstr("cut short")));
    ASSERT_EQ(cli_run({"sii", "write", kMasterLink, "0", folder_.file("old")}).code, cli::kDone);
  }
  EXPECT_GT(torn, 0) << "never killed while it wrote";
}

TEST_F(KilledEepromWrite, AnotherSlavesEepromIsNotFinished) {
  EepromJournal journal{kMasterLink, 0, {}, std::vector<std::uint8_t>(64, 0x11), std::vector<std::uint8_t>(64, 0x22)};
  ASSERT_TRUE(keep_journal(journal));
  const auto finish = cli_run({"sii", "finish", kMasterLink, "0"});
  EXPECT_EQ(finish.code, cli::kFailed);
  EXPECT_THAT(finish.err, HasSubstr("another slave"));
  EXPECT_EQ(cli_run({"sii", "alias", kMasterLink, "0", "77"}).code, cli::kFailed) << "the journal would be lost";
  EXPECT_EQ(read(), old_);
  // A whole image is an end, too.
  EXPECT_EQ(cli_run({"sii", "write", kMasterLink, "0", folder_.file("new")}).code, cli::kDone);
  EXPECT_TRUE(pending_journals().empty());
}

}  // namespace
}  // namespace syncline::test
