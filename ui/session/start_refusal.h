// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>
#include <set>

#include "ui/session/live_session.h"
#include "ui/text/message.h"

namespace syncline {
struct Event;
}  // namespace syncline

namespace syncline::ui {

/// Whether the last start of the network in work failed, and for what: among many messages of a start it is the first
/// error that tells it.
class StartRefusal final : public QObject {
  Q_OBJECT

 public:
  explicit StartRefusal(LiveSession& live, QObject* parent = nullptr);

  /// Nothing has run since a start that failed, and nobody has taken note of it.
  [[nodiscard]] bool isRefused() const { return refused_; }
  /// The first error of that start; nothing where the master ended without one.
  [[nodiscard]] const std::optional<Message>& reason() const { return reason_; }
  /// Slaves that are wrong besides, in the same start.
  [[nodiscard]] int furtherSlaves() const {
    return static_cast<int>(slaves_.size()) - (reason_ && reason_->slave >= 0);
  }
  void forget();

 Q_SIGNALS:
  void changed();

 private:
  void follow();
  void take(const Event& event);

  LiveSession& live_;
  const NetworkRun* run_ = nullptr;  // of which the phase is
  LiveSession::Phase phase_ = LiveSession::Phase::kOffline;
  bool refused_ = false;
  std::optional<Message> reason_;
  std::set<int> slaves_;  // with an error
};

}  // namespace syncline::ui
