// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ui/editors/page.h"
#include "ui/session/running_slave.h"
#include "ui/session/slave_requests.h"

class QLabel;

namespace syncline::ui {

/// A tab about one slave of the running bus: asks it through the requests, and says what to do where there is no bus or
/// no such slave on it.
class OnlinePage : public Page {
  Q_OBJECT

 public:
  [[nodiscard]] bool appliesTo(int slave) const override { return slave >= 0; }
  void refresh() final;
  void showLive(const Snapshot& snapshot) final;

 protected:
  OnlinePage(Workspace& workspace, const char* object_name, const QString& title);
  ~OnlinePage() override;

  /// Another slave is shown, or another run has begun: nothing that was read holds.
  virtual void slaveChanged() = 0;
  /// The project has changed, the slave is the same.
  virtual void projectChanged() {}
  /// On each tick while visible. `obstacle`: why the slave cannot be asked, empty when it can.
  virtual void tick(const Snapshot& snapshot, const QString& obstacle) = 0;
  /// Why this page cannot ask the slave although it is there; empty: it can.
  [[nodiscard]] virtual QString ownObstacle(const RunningSlave&) const { return {}; }

  [[nodiscard]] std::optional<RunningSlave> running() const { return runningSlave(workspace(), node()); }
  [[nodiscard]] QString obstacle() const;
  /// `done` comes later, unless another slave is shown by then.
  void post(SlaveRequest request, SlaveRequests::Done done, RequestUrgency urgency = RequestUrgency::kPerson);
  [[nodiscard]] const SlaveSettings* settings() const;
  /// What is to be done, in the first line of the page; hidden while there is nothing to say.
  [[nodiscard]] QLabel* hint() { return hint_; }
  /// Asks before a slave that drives something gets `what`; true at once for others.
  [[nodiscard]] bool mayDisturb(const QString& what, const QString& more, const QString& on);

 private:
  void forget();

  QLabel* hint_;
  int shown_ = -1;
  std::uint16_t station_ = 0;
  Identity identity_{};
};

}  // namespace syncline::ui
