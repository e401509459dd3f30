// SPDX-License-Identifier: Apache-2.0
#include "protocol/al_state.h"

#include <gtest/gtest.h>

#include <set>

#include "protocol/al_state_rank.h"
#include "protocol/command.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

TEST(AlState, BootIsNoStepOnTheWayToOp) {
  constexpr AlState kWay[] = {AlState::kNone, AlState::kInit, AlState::kPreop, AlState::kSafeop, AlState::kOp};
  for (std::size_t i = 1; i < std::size(kWay); ++i) EXPECT_LT(al_state_rank(kWay[i - 1]), al_state_rank(kWay[i]));
  EXPECT_GT(al_state_rank(AlState::kBoot), al_state_rank(AlState::kInit));
  EXPECT_LT(al_state_rank(AlState::kBoot), al_state_rank(AlState::kPreop));
}

TEST(AlState, NamesGoBothWays) {
  for (const auto state : {AlState::kInit, AlState::kPreop, AlState::kBoot, AlState::kSafeop, AlState::kOp}) {
    EXPECT_EQ(al_state_from_name(al_state_name(state)), state);
    EXPECT_EQ(al_state_letter(state).size(), 1U);
  }
  EXPECT_EQ(al_state_from_name("Pre-Op"), AlState::kPreop);
  EXPECT_EQ(al_state_from_name("safe_op"), AlState::kSafeop);
  EXPECT_EQ(al_state_from_name("Bootstrap"), AlState::kBoot);
  EXPECT_FALSE(al_state_from_name("RUN"));
  EXPECT_FALSE(al_state_from_name(""));
}

TEST(AlState, ErrorFlagIsNotPartOfTheState) {
  EXPECT_EQ(al_state_of(0x0014), AlState::kSafeop);
  EXPECT_EQ(al_state_name(al_state_of(0x000C)), "MIXED");  // SAFEOP and OP, wire-ored
  EXPECT_EQ(al_state_name(AlState::kNone), "NONE");
}

TEST(Transition, NamesAndEndsAgree) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Transition::kBI); ++i) {
    const auto transition = static_cast<Transition>(i);
    names.insert(transition_name(transition));
    EXPECT_EQ(transition_from_name(transition_name(transition)), transition);
  }
  EXPECT_EQ(names.size(), 15U);
  EXPECT_EQ(transition_between(AlState::kPreop, AlState::kSafeop), Transition::kPS);
  EXPECT_EQ(transition_between(AlState::kOp, AlState::kPreop), Transition::kOP);
  EXPECT_EQ(transition_between(AlState::kInit, AlState::kBoot), Transition::kIB);
  EXPECT_FALSE(transition_between(AlState::kBoot, AlState::kOp));
  EXPECT_FALSE(transition_between(AlState::kNone, AlState::kNone));
  EXPECT_FALSE(transition_from_name("XY"));
}

TEST(AlStatusCode, HasMeaningAndHint) {
  EXPECT_EQ(al_status_code_text(0x001B).meaning, "SyncManager watchdog");
  EXPECT_FALSE(al_status_code_text(0x001B).check.empty());
  EXPECT_EQ(al_status_code_text(0x0000).meaning, "no error");
  EXPECT_EQ(al_status_code_text(0x8001).meaning, "vendor specific code");
  EXPECT_EQ(al_status_code_text(0x7FFF).meaning, "unknown code");
  for (const std::uint16_t code : {0x11, 0x16, 0x17, 0x1A, 0x1D, 0x1E, 0x24, 0x25, 0x2C, 0x2D, 0x30, 0x32, 0x36}) {
    EXPECT_NE(al_status_code_text(code).meaning, "unknown code") << code;
    EXPECT_FALSE(al_status_code_text(code).check.empty()) << code;
  }
}

TEST(Command, NamesAndKinds) {
  EXPECT_EQ(command_name(Command::kNop), "NOP");
  EXPECT_EQ(command_name(Command::kLrw), "LRW");
  EXPECT_EQ(command_name(Command::kFrmw), "FRMW");
  EXPECT_EQ(command_name(static_cast<Command>(15)), "?");
  for (int c = 1; c <= kLastCommand; ++c) {
    const auto command = static_cast<Command>(c);
    const int kinds =
        is_logical(command) + is_auto_increment(command) + is_fixed_address(command) + is_broadcast(command);
    EXPECT_EQ(kinds, 1) << command_name(command);
    const auto name = command_name(command);
    EXPECT_EQ(writes(command), name.find('W') != std::string_view::npos) << name;
  }
}

TEST(Registers, AreFoundByAnyByteTheyHold) {
  EXPECT_EQ(reg::name(reg::kSystemTimeDifference), "System time difference");
  EXPECT_EQ(reg::name(reg::kSystemTimeDifference + 3), "System time difference");
  EXPECT_EQ(reg::name(reg::kSpeedCounterStart), "Speed counter start");
  EXPECT_EQ(reg::name(reg::fmmu(3) + 5), "FMMU 3");
  EXPECT_EQ(reg::name(reg::sync_manager(15) + 7), "SyncManager 15");
  EXPECT_EQ(reg::name(0x1000), "Process data RAM");
  EXPECT_EQ(reg::name(0x0014), "");
  EXPECT_EQ(reg::name(0x0880), "");
}

TEST(Registers, EveryNamedAddressConstantHasAName) {
  for (const auto address : {reg::kType,
                             reg::kBuild,
                             reg::kFmmuCount,
                             reg::kFeatures,
                             reg::kStationAddress,
                             reg::kStationAlias,
                             reg::kEscReset,
                             reg::kDlControl,
                             reg::kDlControlLoop,
                             reg::kDlControlAlias,
                             reg::kDlStatus,
                             reg::kAlControl,
                             reg::kAlStatus,
                             reg::kAlStatusCode,
                             reg::kPdiControl,
                             reg::kEcatEventMask,
                             reg::kAlEventMask,
                             reg::kEcatEventRequest,
                             reg::kAlEventRequest,
                             reg::kRxErrorCounter,
                             reg::kForwardedErrorCounter,
                             reg::kProcessingUnitErrorCounter,
                             reg::kPdiErrorCounter,
                             reg::kLostLinkCounter,
                             reg::kWatchdogDivider,
                             reg::kWatchdogPdi,
                             reg::kWatchdogProcessData,
                             reg::kWatchdogStatus,
                             reg::kWatchdogCounterProcessData,
                             reg::kSiiConfiguration,
                             reg::kSiiControl,
                             reg::kSiiAddress,
                             reg::kSiiData,
                             reg::kReceiveTimePort0,
                             reg::kReceiveTimePort3,
                             reg::kSystemTime,
                             reg::kReceiveTimeProcessingUnit,
                             reg::kSystemTimeOffset,
                             reg::kSystemTimeDelay,
                             reg::kSpeedCounterDiff,
                             reg::kFilterDepthDifference,
                             reg::kFilterDepthSpeedCounter,
                             reg::kCyclicUnitControl,
                             reg::kActivation,
                             reg::kPulseLength,
                             reg::kActivationStatus,
                             reg::kSync0Status,
                             reg::kStartTimeCyclicOperation,
                             reg::kNextSync1Pulse,
                             reg::kSync0CycleTime,
                             reg::kSync1CycleTime,
                             reg::kLatch0Control,
                             reg::kLatch1Status,
                             reg::kLatch1NegativeEdge,
                             reg::kEcatBufferChangeTime}) {
    EXPECT_NE(reg::name(address), "") << std::hex << address;
  }
}

}  // namespace
}  // namespace syncline
