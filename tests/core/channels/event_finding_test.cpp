// SPDX-License-Identifier: Apache-2.0
#include "channels/event_finding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "findings/figure.h"
#include "findings/finding.h"
#include "tests/support/every_event.h"

namespace syncline {
namespace {

Finding told(int slave, EventDetails what) { return event_finding(Event{0, slave, std::move(what)}).value(); }

bool is_phrase(const std::string& text) {
  return std::ranges::find(finding_phrases(), std::string_view(text)) != finding_phrases().end();
}

TEST(EventFinding, EachKindButProgressHasARowWhoseFiguresAreFilled) {
  for (const auto& event : test::one_of_each()) {
    const auto finding = event_finding(event);
    ASSERT_EQ(finding.has_value(), !event.is<events::ScanProgress>()) << event.what.index();
    if (!finding) continue;
    EXPECT_NE(find_finding_words(finding->code), nullptr) << finding->code;
    EXPECT_EQ(facts_text(*finding).find('{'), std::string::npos) << facts_text(*finding);
    for (const auto& figure : finding->figures) {
      const bool ours = figure.unit == Figure::Unit::kPhrase || figure.unit == Figure::Unit::kAside;
      EXPECT_TRUE(!ours || figure.text.empty() || is_phrase(figure.text)) << finding->code << ": " << figure.text;
    }
  }
}

TEST(EventFinding, TheMasterIsNoSlave) {
  EXPECT_EQ(facts_text(told(-1, events::StateChanged{AlState::kOp, AlState::kNone})), "master: OP -> unknown");
  EXPECT_EQ(facts_text(told(2, events::StateChanged{AlState::kPreop, AlState::kSafeop})), "slave 2: PREOP -> SAFEOP");
  EXPECT_EQ(told(2, events::SlaveLost{}).place.slave, 2);
}

TEST(EventFinding, WeighsWhatItTells) {
  using Stage = events::RecoveryStep::Stage;
  EXPECT_EQ(told(1, events::RecoveryStep{Stage::kDone, 1}).severity, Severity::kNote);
  EXPECT_EQ(told(1, events::RecoveryStep{Stage::kFailed, 1}).severity, Severity::kWarning);
  EXPECT_EQ(told(1, events::RecoveryStep{Stage::kGivenUp, 3}).severity, Severity::kError);
  EXPECT_EQ(told(-1, events::WkcExpected{9, 9}).severity, Severity::kNote);
  EXPECT_EQ(told(-1, events::WkcExpected{9, 6}).severity, Severity::kWarning);
}

TEST(EventFinding, OutputsThatAreReleasedLeaveNothingToDo) {
  const auto forced = find_finding_words(told(-1, events::OutputsForced{16}).code),
             released = find_finding_words(told(-1, events::OutputsForced{0}).code);
  EXPECT_FALSE(forced->mend.empty());
  EXPECT_EQ(released->mend, "");
}

TEST(EventFinding, AFailureIsTheFindingOfItsError) {
  const auto finding = told(-1, events::Failure{{ErrorCode::kNoResponse, "slave 3"}});
  EXPECT_EQ(finding.code, "no-response");
  EXPECT_EQ(finding.severity, Severity::kError);
}

TEST(EventFinding, OneIsNotSeveral) {
  EXPECT_EQ(facts_text(told(-1, events::FramesLost{1})), "1 frame lost");
  EXPECT_EQ(facts_text(told(-1, events::OutputsForced{1})), "outputs are forced: 1 bit");
  EXPECT_EQ(facts_text(told(-1, events::OutputsForced{16})), "outputs are forced: 16 bits");
  EXPECT_EQ(told(-1, events::OutputsForced{0}).severity, Severity::kNote);
  EXPECT_EQ(facts_text(told(-1, events::FramesLost{7})), "7 frames lost");
  EXPECT_EQ(facts_text(told(2, events::PortErrors{1, 1, 0})), "slave 2 port B: 1 damaged frame");
  EXPECT_EQ(facts_text(told(-1, events::DcInitialised{1, 0})),
            "distributed clocks initialised: 1 slave, reference clock is slave 0");
  EXPECT_EQ(facts_text(told(-1, events::DelaysMeasured{1, -20})),
            "propagation delays measured again: 1 slave to correct, by -20 ns");
}

TEST(EventFinding, ADelayIsToldInItsUnit) {
  EXPECT_EQ(facts_text(delay_finding(4, dc::DelayWarning::kUnexplainedPort, 2)),
            "slave 4: port C has a link and no slave behind it: a closed ring or another master");
  EXPECT_EQ(facts_text(delay_finding(4, dc::DelayWarning::kUntimedPort, 1)),
            "slave 4: the receive time of its port B contradicts all others and is left out");
  EXPECT_EQ(facts_text(delay_finding(4, dc::DelayWarning::kUnmeasuredWay, 12'000)),
            "slave 4: the delay to it and to those behind it cannot be measured, because the slave at which their "
            "branch parts has no receive times; 12 us is taken, which is wrong by the cables of both branches (some "
            "100 ns)");
  EXPECT_EQ(facts_text(delay_finding(4, dc::DelayWarning::kImplausibleHop, 1'500'000)),
            "slave 4: the delay to it is implausible (1.5 ms); 0 is taken");
}

}  // namespace
}  // namespace syncline
