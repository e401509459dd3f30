// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "support/types.h"

namespace syncline {
struct ReplayedRun;
}  // namespace syncline

namespace syncline::ui {

struct Message;

/// What a recording holds of messages, the latest `most` of them, oldest first: events as the run told them; where only
/// their words are known, those; findings of which only the words are known; notes. In any thread.
[[nodiscard]] std::vector<Message> messagesOf(const ReplayedRun& run, std::size_t most);

/// Of what and when, how long, and how it ended: "machine.syncline on sim:demo, 2026-03-01 12:00:00, 10 min 0 s ...".
[[nodiscard]] QString recordingText(const ReplayedRun& run);

/// "12 s", "4 min 10 s", "2 h 5 min".
[[nodiscard]] QString spanText(Nanoseconds span);

}  // namespace syncline::ui
