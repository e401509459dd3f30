// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

struct StateText;

class NetworkRun;

/// Whether the master of a network runs, and the link carries frames: "Online".
[[nodiscard]] StateText phaseText(const NetworkRun& run);
/// How a network does, in a few words: "OP", "SAFEOP, DC: out of sync"; nothing of one that is offline.
[[nodiscard]] StateText runState(const NetworkRun& run);
/// Its name with that: "Press: OP".
[[nodiscard]] QString networkText(const QString& name, const NetworkRun& run);

}  // namespace syncline::ui
