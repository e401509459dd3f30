// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

class QLabel;
class QLineEdit;
class QTableView;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class RecordModel;
class WordFilter;

/// All init commands that the project makes, of the whole network or of one slave: what the master sends at which
/// transition, and what has to come back.
class InitCommandsPage final : public Page {
  Q_OBJECT

 public:
  explicit InitCommandsPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  RecordModel* model_;
  WordFilter* filter_;
  QLineEdit* words_;
  QTableView* table_;
  QLabel* count_;
};

}  // namespace syncline::ui
