// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <utility>

class QObject;

namespace syncline::ui {

/// Runs `call` in the window's thread, behind what waits there already, and not at all when `receiver` is gone by then.
/// Any thread, while `receiver` lives: who starts a thread joins it before it goes. The one way back from the window's
/// background threads; what `call` holds was written before it runs, also in the eyes of the thread sanitizer, which
/// does not see into Qt's event queue.
void postCall(QObject& receiver, std::function<void()> call);

/// The same for what can only be moved.
template <class Call>
void post(QObject& receiver, Call call) {
  postCall(receiver, [held = std::make_shared<Call>(std::move(call))] { (*held)(); });
}

}  // namespace syncline::ui
