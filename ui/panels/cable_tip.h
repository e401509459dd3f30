// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

class CableCounters;
class NetworkModel;

/// All that is known of the cable by which a slave hangs: its link, and what both ends counted since going online, how
/// fast it grows and when it was read. Empty: nobody knows the cable.
[[nodiscard]] QString cableTip(const NetworkModel& network, const CableCounters& cables, int slave);

}  // namespace syncline::ui
