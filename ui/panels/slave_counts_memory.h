// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

class LiveStrip;
class WindowMemory;

/// How many slaves, the worst of them, each plot draws is remembered from one start to the next.
void rememberSlaveCounts(LiveStrip& strip, WindowMemory& memory);

}  // namespace syncline::ui
