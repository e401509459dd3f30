// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

class QLabel;
class QLineEdit;
class QTableView;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::settings {
struct Place;
struct Setting;
}  // namespace syncline::settings

namespace syncline::ui {

class RecordEditor;
class RecordModel;
class WordFilter;

/// All init commands that the project makes, of the whole network or of one slave: what the master sends at which
/// transition, and what has to come back; below them register commands of the user's own.
class InitCommandsPage final : public Page {
  Q_OBJECT

 public:
  explicit InitCommandsPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showPlace(const settings::Setting& setting, const settings::Place& place) override;
  void showLive(const Snapshot&) override {}

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showOwn();
  void showAll();
  RecordModel* model_;
  WordFilter* filter_;
  QLineEdit* words_;
  QTableView* table_;
  QLabel* count_;
  RecordEditor *of_slave_, *of_master_;
};

}  // namespace syncline::ui
