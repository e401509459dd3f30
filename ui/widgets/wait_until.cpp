// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/wait_until.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

namespace syncline::ui {
namespace {

constexpr int kLookEveryMs = 10;  // what changes without an event is seen then

}  // namespace

void waitForEvents() {
  QTimer wake;
  wake.setTimerType(Qt::PreciseTimer);
  wake.start(kLookEveryMs);
  QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

bool waitUntil(const std::function<bool()>& done, qint64 timeout_ms) {
  QElapsedTimer waiting;
  waiting.start();
  while (!done()) {
    if (waiting.elapsed() > timeout_ms) return false;
    waitForEvents();
  }
  return true;
}

}  // namespace syncline::ui
