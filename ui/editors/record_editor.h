// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "ui/editors/record_part.h"

class QLabel;
class QTableView;

namespace syncline::ui {

class Card;
class Page;
class RecordForm;
class RecordModel;

/// A list of records: a table with its buttons, and beside it fields for the parts of the selected record.
class RecordEditor final : public QWidget {
  Q_OBJECT

 public:
  /// Object names begin with `name`: nameTable, nameAdd ... `beside`: the fields stand right of the table, else below.
  RecordEditor(Page& page, const char* name, const QString& title, RecordList list, std::vector<RecordPart> parts,
               bool beside);

  /// Shows the list as it is now; before the page refreshes its fields.
  void showRecords();
  /// After them.
  void refreshButtons();
  /// Without records it is one line with its buttons: for lists that most machines do not need.
  void foldWhenEmpty();
  void select(int row);
  [[nodiscard]] int row() const;
  [[nodiscard]] Card& card() { return *card_; }
  [[nodiscard]] RecordForm& form() { return *form_; }

 private:
  Page& page_;
  std::vector<RecordPart> columns_;
  std::function<Records()> read_;
  RecordModel* model_;
  QTableView* table_;
  RecordForm* form_;
  Card* card_;
  QLabel* nothing_;
  QWidget* none_ = nullptr;  // stands in the heading while it is folded
  bool folds_ = false;
  bool showing_ = false;  // rows come and go because the project says so
};

}  // namespace syncline::ui
