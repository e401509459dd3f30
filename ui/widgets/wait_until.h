// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>
#include <functional>

namespace syncline::ui {

/// Runs the event loop of this thread until `done`, which is asked after every event and at least every 10 ms, for at
/// most `timeout_ms` milliseconds (0 and more); whether it is done at the end. The thread sleeps while nothing happens:
/// QCoreApplication::processEvents with a time does not, whatever flags it is given, and takes the processor from the
/// thread that is waited for. Needs an application object; for programs without a user in front, and tests.
bool waitUntil(const std::function<bool()>& done, qint64 timeout_ms);

/// One turn of that: handles what has come, and sleeps until something comes where nothing has, for at most 10 ms.
void waitForEvents();

}  // namespace syncline::ui
