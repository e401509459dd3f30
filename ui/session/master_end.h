// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>

namespace syncline {
class BackgroundMaster;
}  // namespace syncline

namespace syncline::ui {

/// Ends a master, which takes its slaves to INIT and waits for its thread, in a thread beside the window's. False when
/// it has not ended within `patience`: then it is left alone there, alive as long as its thread is, and ends when that
/// does. One that has no thread of its own ends at once.
bool endMaster(std::unique_ptr<BackgroundMaster> master, std::chrono::milliseconds patience);

}  // namespace syncline::ui
