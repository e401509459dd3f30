// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"
#include "ui/editors/record_part.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class RecordEditor;
class SyncUnitTree;

/// Cyclic tasks beside the base task, and the Sync Units whose slaves are exchanged together.
class MasterTasksPage final : public Page {
  Q_OBJECT

 public:
  explicit MasterTasksPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void showPlace(const settings::Setting& setting, const settings::Place& place) override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 private:
  RecordList tasks();
  RecordList units();
  [[nodiscard]] QList<std::pair<QString, QString>> taskNames() const;
  [[nodiscard]] std::vector<SettingEdit> taskEdits(const Records& before, const Records& after) const;
  [[nodiscard]] std::vector<SettingEdit> unitEdits(const Records& before, const Records& after) const;

  RecordEditor *tasks_, *units_;
  SyncUnitTree* members_;
};

}  // namespace syncline::ui
