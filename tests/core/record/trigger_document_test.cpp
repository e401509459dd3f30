// SPDX-License-Identifier: Apache-2.0
#include "record/trigger_document.h"

#include <gtest/gtest.h>

#include "support/random.h"
#include "trace/signals.h"

namespace syncline {
namespace {

std::vector<KeptTrigger> some_triggers() {
  KeptTrigger level;
  level.trigger.signal = Signal::kSlaveDeviation;
  level.trigger.slave = 3;
  level.trigger.level = 0.1;
  level.trigger.hold_off = 0;
  for (std::uint64_t i = 0; i < 3; ++i) {
    TriggerEpisode episode;
    episode.time = 830'000'000 * kSecond + static_cast<Nanoseconds>(i);
    if (i != 1) episode.cycle = 1000 + i;
    episode.slave = 3;
    episode.value = 1.0 / 3 + static_cast<double>(i);
    episode.from = episode.time - kSecond;
    episode.to = episode.time + kSecond;
    episode.left_out = i;
    level.episodes.push_back(episode);
  }
  level.names[level.episodes[2].time] = "T\u00FCr\t\\offen\nund = zu";
  KeptTrigger variable;
  variable.trigger.kind = Trigger::Kind::kWindow;
  variable.trigger.signal = Signal::kVariable;
  variable.trigger.variable = "Servo.Position\tvalue";
  variable.trigger.mode = Trigger::Mode::kSingle;
  variable.trigger.magnitude = variable.trigger.enters = true;
  KeptTrigger event;
  event.trigger.kind = Trigger::Kind::kEvent;
  event.trigger.code = "event-slave-lost";
  return {level, variable, event};
}

TEST(TriggerDocument, ComesBackAsItWas) {
  const auto kept = some_triggers();
  RecordingAbout about;
  about.documents.push_back({"project", "m.syncline", "trigger\tkind=0"});
  about.documents.push_back(trigger_document(kept));
  EXPECT_EQ(kept_triggers(about), kept);
}

TEST(TriggerDocument, EachSignalThatIsDrawnComesBack) {
  for (const auto& row : signals()) {
    if (row.form == SignalInfo::Form::kCell) continue;
    KeptTrigger kept;
    kept.trigger.signal = row.id;
    RecordingAbout about;
    about.documents.push_back(trigger_document(std::span(&kept, 1)));
    EXPECT_EQ(kept_triggers(about), std::vector{kept}) << row.key;
  }
}

TEST(TriggerDocument, WhatIsDamagedIsPassedOver) {
  const auto document = trigger_document(some_triggers());
  RecordingAbout about;
  about.documents.push_back(document);
  auto& body = about.documents.front().body;
  body.replace(body.find("slave=3"), 7, "slave=x");  // of the first trigger: its episodes belong to nobody
  const auto rest = kept_triggers(about);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_TRUE(rest.front().episodes.empty());
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    body = document.body;
    for (int hit = 0; hit < 3; ++hit) body[random.next() % body.size()] = static_cast<char>(random.next());
    EXPECT_LE(kept_triggers(about).size(), 8U);
    body.resize(random.next() % body.size());
    EXPECT_LE(kept_triggers(about).size(), 8U);
  }
}

}  // namespace
}  // namespace syncline
