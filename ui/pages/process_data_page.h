// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ui/editors/page.h"

class QLabel;
class QTableView;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::settings {
struct Place;
struct Setting;
}  // namespace syncline::settings

namespace syncline::ui {

class PdoModel;
class PdoMappingEditor;
class TextEdit;

/// PDO assignment of a slave by check boxes, both directions, and the mapping of the selected PDO.
class ProcessDataPage final : public Page {
  Q_OBJECT

 public:
  explicit ProcessDataPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void showPlace(const settings::Setting& setting, const settings::Place& place) override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 private:
  QWidget* buildDirection(PdoModel* model, QTableView*& view, QLabel*& size, const char* object_name,
                          const QString& title);
  QWidget* buildEntries();
  QWidget* buildName();
  void showEntriesOf(PdoModel* model, int row);
  void showMapping();
  [[nodiscard]] std::optional<settings::Place> namedEntry() const;

  PdoModel *outputs_, *inputs_;
  QTableView *outputs_view_, *inputs_view_;
  QLabel *outputs_size_, *inputs_size_;
  PdoMappingEditor* mapping_ = nullptr;
  TextEdit* name_ = nullptr;
  int shown_node_ = -2;
};

}  // namespace syncline::ui
