// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <vector>

class QLabel;
class QTableView;

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

struct RecordList;
struct RecordPart;

class Card;
class Page;
class PdoEntryModel;
class RecordForm;

/// What one PDO carries: its entries in order, and fields for the selected one where the mapping is not fixed.
class PdoMappingEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit PdoMappingEditor(Page& page);

  /// 0: none. After it, refresh().
  void showPdo(std::uint16_t pdo, const QString& title);
  [[nodiscard]] std::uint16_t pdo() const { return pdo_; }
  /// The selected entry, -1: none.
  [[nodiscard]] int row() const;
  void selectRow(int row);
  /// Before the page refreshes its fields, and after them.
  void showEntries();
  void refreshButtons();
  [[nodiscard]] Card& card() { return *card_; }

 Q_SIGNALS:
  void rowChanged();

 private:
  RecordList list();
  std::vector<RecordPart> parts();
  void chooseObject();
  [[nodiscard]] const SlaveSettings* slave() const;
  [[nodiscard]] QString refusal() const;
  [[nodiscard]] bool outputs() const;

  Page& page_;
  std::uint16_t pdo_ = 0;
  QLabel *title_, *refusal_;
  PdoEntryModel* model_;
  QTableView* view_;
  RecordForm* form_;
  Card* card_;
  QWidget* choose_;
  bool showing_ = false;
};

}  // namespace syncline::ui
