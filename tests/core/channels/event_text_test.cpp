// SPDX-License-Identifier: Apache-2.0
#include "channels/event_text.h"

#include <gtest/gtest.h>

#include "channels/event.h"
#include "channels/event_finding.h"
#include "channels/event_name.h"
#include "findings/finding.h"
#include "protocol/diagnosis_message.h"
#include "tests/support/every_event.h"

namespace syncline {
namespace {

TEST(EventText, EveryKindHasANameAndAllButProgressHaveWords) {
  for (const auto& event : test::one_of_each()) {
    EXPECT_FALSE(event_name(event).empty()) << event.what.index();
    const auto finding = event_finding(event);
    EXPECT_TRUE(!finding || finding->code.starts_with("event-") || event.is<events::Failure>()) << event.what.index();
    const bool silent = event.is<events::ScanProgress>() || event.is<events::MasterStopped>();
    EXPECT_EQ(event_words(event).empty(), silent) << event.what.index();
  }
}

struct Said {
  Event event;
  const char* words;
};

TEST(EventText, SaysWhatAProgramMayHaveLearnedToRead) {
  using Which = events::WatchdogExpired::Which;
  using What = events::ReferenceClockChanged::What;
  const Said kSaid[] = {
      {{0, 3, events::StateChanged{AlState::kPreop, AlState::kSafeop}}, "slave 3: PREOP -> SAFEOP"},
      {{0, 3, events::SlavesInSync{12}}, "slave 3 in sync again, deviation 12 ns"},
      {{0, -1, events::SlavesInSync{12}}, "slaves in sync, deviation 12 ns"},
      {{0, 4, events::SlavesOutOfSync{5000, 2}},
       "slaves OUT OF SYNC, deviation 5 us at slave 4 (2 slaves are over the limit)"},
      {{0, -1, events::SlavesOutOfSync{5000, 3}},
       "slaves OUT OF SYNC, deviation 5 us: all 3 at once and to the same side, the reference clock has stepped or "
       "changed its rate"},
      {{0, -1, events::SlavesSyncUnknown{40 * kMillisecond}},
       "slaves: not known whether in sync, nothing was read for 40 ms"},
      {{0, -1, events::MasterInSync{-7}}, "master in sync, error -7 ns"},
      {{0, 1, events::ReferenceClockChanged{What::kTookOver}}, "reference clock slave 1: took over"},
      {{0, -1, events::WkcError{12, 9, 4}}, "working counter 9 instead of 12 (4 times)"},
      {{0, -1, events::WkcExpected{12, 9}}, "working counter expected now 9 (all slaves: 12)"},
      {{0, -1, events::FramesLost{1}}, "1 frame lost"},
      {{0, -1, events::FramesLate{3, 1'500'000, 2}},
       "3 frames back late, up to 1.5 ms after the deadline (2 of them told as lost before)"},
      {{0, -1, events::CyclesLeftOut{2, 3'100'000}}, "2 cycles left out, the host sent nothing for up to 3.1 ms"},
      {{0, 2, events::PortErrors{1, 3, 1}}, "slave 2 port B: 3 damaged frames, link lost once"},
      {{0, 2, events::WatchdogExpired{Which::kPdi, 1}}, "slave 2: PDI watchdog expired (once): its firmware is silent"},
      {{0, 2, events::LongCycles{true, 5}},
       "slave 2: 5 of its cycles took longer than the cycle time: its firmware is slow"},
      {{0, 2, events::StaleProcessData{true, 9, 16}},
       "slave 2: no new inputs in 9 of 16 cycles, where each brought some before: its firmware is slow"},
      {{0, -1, events::CableChanged{0, 0, true}}, "cable between master port A and slave 0: healed"},
      {{0, 5, events::Emergency{0x8611, 0x20, {1, 2, 3, 4, 0xFF}, {}}},
       "slave 5: emergency 0x8611, error register 0x20, data 01 02 03 04 ff"},
      {{0, 5, events::DiagnosisTold{0xE000, DiagnosisMessage::Type::kWarning, 0x1A, 0}},
       "slave 5: diagnosis warning 0x0000e000, text 0x001a"},
      {{0, 5, events::DiagnosisTold{0xE000, DiagnosisMessage::Type::kWarning, 0x1A, 62'500'000'000}},
       "slave 5: diagnosis warning 0x0000e000, text 0x001a, time stamp 62.5 s"},
      {{0, 7, events::UnknownSlave{{2, 0x44C2C52, 0x120000, 0}}},
       "unknown device at position 7: 0x00000002:0x044c2c52:0x00120000"},
      {{0, -1, events::LinkUp{SharedText("nic:eth0"), 1'200 * kMillisecond}},
       "network adapter nic:eth0 is up again after 1.2 s"},
      {{0, 6, events::HotConnect{events::HotConnect::What::kConnected, SharedText("tool")}},
       "slave 6: connected (hot-connect group \"tool\")"},
      {{0, -1, events::EventsLost{9}}, "9 events were lost"},
  };
  for (const auto& said : kSaid) EXPECT_EQ(event_words(said.event), said.words);
}

}  // namespace
}  // namespace syncline
