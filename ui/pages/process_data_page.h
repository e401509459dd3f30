// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

class QLabel;
class QTableView;

namespace syncline::ui {

class PdoModel;
class PdoEntryModel;

/// PDO assignment of a slave by check boxes, both directions, and the entries of the selected PDO.
class ProcessDataPage final : public Page {
  Q_OBJECT

 public:
  explicit ProcessDataPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 private:
  QWidget* buildDirection(PdoModel* model, QTableView*& view, QLabel*& size, const char* object_name,
                          const QString& title);
  QWidget* buildEntries();
  void showEntriesOf(PdoModel* model, int row);

  PdoModel *outputs_, *inputs_;
  QTableView *outputs_view_, *inputs_view_, *entries_view_;
  QLabel *outputs_size_, *inputs_size_, *entries_title_;
  PdoEntryModel* entries_;
  int shown_node_ = -2;
};

}  // namespace syncline::ui
