// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "config/identity.h"
#include "ui/editors/page.h"
#include "ui/session/running_slave.h"
#include "ui/session/slave_requests.h"

class QLabel;
class QVBoxLayout;

namespace syncline {
struct SlaveSettings;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class ValueLabel;

/// A tab about one slave of the running bus: asks it through the requests, and says what to do where there is no bus or
/// no such slave on it.
class OnlinePage : public Page {
  Q_OBJECT

 public:
  [[nodiscard]] bool appliesTo(int slave) const override { return slave >= 0; }
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kDiagnosis; }
  void refresh() final;
  void showLive(const Snapshot& snapshot) final;

 protected:
  OnlinePage(Workspace& workspace, const char* object_name, const QString& title);
  ~OnlinePage() override;

  /// The page's content, with what is to be done in its first line (hidden while there is nothing to say); the parts
  /// follow in this layout.
  [[nodiscard]] QVBoxLayout* build();
  /// The line that say() writes into.
  [[nodiscard]] ValueLabel* buildStatus(const char* object_name);
  /// What became of the last request.
  void say(const QString& text, bool bad = false);

  /// Another slave is shown, or another run has begun: nothing that was read holds. After ended().
  virtual void slaveChanged() = 0;
  /// Another run has begun, or another machine is edited: what was kept of any slave does not hold.
  virtual void machineChanged() {}
  /// Nothing that was asked will be answered any more; also while the page is hidden or its slave gone.
  virtual void ended() {}
  /// The project has changed, the slave is the same.
  virtual void projectChanged() {}
  /// On each tick while visible. `now`: of the run, as answers are stamped; nothing while none goes on.
  virtual void tick(std::optional<Nanoseconds> now) = 0;
  /// Why this page cannot ask the slave although it is there; empty: it can.
  [[nodiscard]] virtual QString ownObstacle(const RunningSlave&) const { return {}; }

  [[nodiscard]] std::optional<RunningSlave> running() const { return runningSlave(workspace(), node()); }
  /// Where the shown slave stands in the run that goes on or was the last one; -1: it was not in it.
  [[nodiscard]] int position() const;
  /// Why the slave cannot be asked, in words; empty: it can.
  [[nodiscard]] QString obstacle() const;
  /// That there was none at the last tick.
  [[nodiscard]] bool possible() const { return possible_; }
  /// `done` comes later, unless another slave is shown by then.
  SlaveRequests::Id post(SlaveRequest request, SlaveRequests::Done done,
                         RequestUrgency urgency = RequestUrgency::kPerson);
  /// Whatever was asked ends unheard.
  void stopAsking();
  [[nodiscard]] const SlaveSettings* settings() const;
  /// Of the project's slave: objects, and the history that is one of them, are asked for by CoE.
  [[nodiscard]] bool speaksCoe(int slave) const;
  /// Asks before a slave that drives something gets `what`; true at once for others.
  [[nodiscard]] bool mayDisturb(const QString& what, const QString& more, const QString& on);

 private:
  [[nodiscard]] bool same() const;
  void forget();

  QLabel* hint_;
  ValueLabel* status_ = nullptr;
  int shown_ = -1;
  std::uint16_t station_ = 0;
  Identity identity_{};
  bool possible_ = false;
};

}  // namespace syncline::ui
