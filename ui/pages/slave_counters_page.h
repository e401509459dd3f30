// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "channels/slave_evidence.h"
#include "ui/models/count_history.h"
#include "ui/pages/online_page.h"

class QLabel;
class QTableView;

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
  void tick(std::optional<Nanoseconds> now) override;

 private:
  void showPorts(const SlaveEvidence& evidence);
  void showOthers(const SlaveEvidence& evidence, std::optional<Nanoseconds> now);
  [[nodiscard]] QString ageText(Nanoseconds time, std::optional<Nanoseconds> now) const;

  CountHistory history_;
  std::optional<SlaveEvidence> last_;  // stays when the run is over
  RecordModel *ports_, *others_;
  QTableView *port_table_, *other_table_;
  QLabel *age_, *means_;
};

}  // namespace syncline::ui
