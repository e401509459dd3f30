// SPDX-License-Identifier: Apache-2.0
#include "ui/session/post.h"

#include <QCoreApplication>
#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QThread>

#ifdef SYNCLINE_SANITIZED_THREAD
extern "C" {
void __tsan_acquire(void* address);
void __tsan_release(void* address);
}
#endif

namespace syncline::ui {
namespace {

void announce([[maybe_unused]] QEvent* event) {
#ifdef SYNCLINE_SANITIZED_THREAD
  __tsan_release(event);
#endif
}

void take([[maybe_unused]] QEvent* event) {
#ifdef SYNCLINE_SANITIZED_THREAD
  __tsan_acquire(event);
#endif
}

const QEvent::Type kCall = static_cast<QEvent::Type>(QEvent::registerEventType());

class CallEvent final : public QEvent {
 public:
  CallEvent(QObject& receiver, std::function<void()> call)
      : QEvent(kCall), receiver_(&receiver), call_(std::move(call)) {}
  void run() const {
    if (receiver_) call_();
  }

 private:
  QPointer<QObject> receiver_;
  std::function<void()> call_;
};

/// Takes the calls for all; lives in the window's thread, whoever needs it first.
class Courier final : public QObject {
 public:
  Courier() { moveToThread(QCoreApplication::instance()->thread()); }
  bool event(QEvent* event) override {
    take(event);
    if (event->type() != kCall) return QObject::event(event);
    static_cast<CallEvent*>(event)->run();
    return true;
  }
};

}  // namespace

void postCall(QObject& receiver, std::function<void()> call) {
  static Courier courier;
  auto* event = new CallEvent(receiver, std::move(call));
  announce(event);
  QCoreApplication::postEvent(&courier, event);
}

}  // namespace syncline::ui
