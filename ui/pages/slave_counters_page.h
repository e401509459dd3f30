// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/count_history.h"
#include "ui/pages/online_page.h"

class QLabel;

namespace syncline::ui {

class RecordModel;

/// Error counters of each port and expirations of the watchdogs since going online, with how fast they grow. The master
/// reads them anyway: nothing is asked for here.
class SlaveCountersPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveCountersPage(Workspace& workspace);

 protected:
  void slaveChanged() override;
  void tick(const Snapshot& snapshot, const QString& obstacle) override;

 private:
  void showPorts(const SlaveEvidence& evidence);
  void showOthers(const SlaveEvidence& evidence, Nanoseconds now);
  [[nodiscard]] QString ageText(Nanoseconds time, Nanoseconds now) const;

  CountHistory history_;
  RecordModel *ports_, *others_;
  QLabel *age_, *means_;
};

}  // namespace syncline::ui
