// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

#include "channels/cycle_sample.h"
#include "ui/theme/theme.h"

namespace syncline {
struct SlavesStanding;
struct Snapshot;
}  // namespace syncline

/// The synchronisation states in words and tones, the same in the pages and in the status bar.
namespace syncline::ui {

struct StateText {
  theme::Tone tone = theme::Tone::kNeutral;
  QString text;
};

[[nodiscard]] theme::Tone syncTone(SyncState state);
[[nodiscard]] StateText slavesSync(const Snapshot& snapshot);
/// The verdict speaks of those who answer. Where slaves that were part of it do not, that is what is said in its place:
/// a machine with dead followers is not in sync.
[[nodiscard]] StateText withSilent(StateText verdict, const std::optional<SlavesStanding>& standing);
[[nodiscard]] StateText masterSync(const Snapshot& snapshot);

}  // namespace syncline::ui
