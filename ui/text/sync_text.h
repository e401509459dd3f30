// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "channels/snapshot.h"
#include "ui/theme/theme.h"

/// The synchronisation states in words and tones, the same in the pages and in the status bar.
namespace syncline::ui {

struct StateText {
  theme::Tone tone = theme::Tone::kNeutral;
  QString text;
};

[[nodiscard]] theme::Tone syncTone(SyncState state);
[[nodiscard]] StateText slavesSync(const Snapshot& snapshot);
[[nodiscard]] StateText masterSync(const Snapshot& snapshot);

}  // namespace syncline::ui
