// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "channels/snapshot.h"
#include "channels/values/sync_obstacle.h"
#include "config/dcm_settings.h"
#include "protocol/al_state.h"

namespace syncline {
struct NetworkConfig;
struct Project;
}  // namespace syncline

/// The words the window uses for the things of the bus. The ETG's present terms are MainDevice and
/// SubDevice, ESI and ENI files say Master and Slave: here it is decided.
namespace syncline::ui {

[[nodiscard]] QString masterWord();
[[nodiscard]] QString slaveWord();
[[nodiscard]] QString stateName(AlState state);  // "SAFEOP", "No response"
/// Of the master: "OP", or "Slaves missing" where one does not answer.
[[nodiscard]] QString masterStateName(AlState state);
[[nodiscard]] QString stateLetter(AlState state);      // "S"
[[nodiscard]] QString syncStateText(SyncState state);  // "In sync"
/// Why the master is not in sync: "cycles left out". Empty for none.
[[nodiscard]] QString obstacleText(dc::SyncObstacle obstacle);
[[nodiscard]] QString dcmModeText(DcmMode mode);  // "Bus shift"
/// "Slave 3 (EL2002)" or the master's name.
[[nodiscard]] QString nodeName(const Project& project, int slave);
[[nodiscard]] QString nodeName(const NetworkConfig& running, int slave);

}  // namespace syncline::ui
