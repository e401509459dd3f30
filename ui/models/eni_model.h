// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

#include "ui/models/eni_view.h"

namespace syncline::ui {

/// The lines of an ENI, with those that are no more; all, or those that changed with some around them.
class EniModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kLine, kChange, kText, kColumns };
  enum Role {
    kKindRole = Qt::UserRole + 1,  // EniRowKind
    kGapRole,                      // the row stands for lines that are left out
    kOtherRole,                    // text of an altered line as it was, or of one that was as it is now
  };

  explicit EniModel(QObject* parent = nullptr);

  /// Null: nothing is shown.
  void setView(std::shared_ptr<const EniView> view);
  void setOnlyChanges(bool only);
  [[nodiscard]] const EniView* view() const { return view_.get(); }

  /// Row that shows a line of the text, from 0, or the nearest before it.
  [[nodiscard]] int rowOf(std::size_t line) const;
  /// Line of the text at a row, from 0.
  [[nodiscard]] std::size_t lineAt(int row) const;
  /// First row of the next stretch of changes behind or before `row`, around the end; -1: there are none.
  [[nodiscard]] int changeFrom(int row, bool forward) const;
  /// The next row behind or before `row` that holds the words, around the end, in any case; -1: none.
  [[nodiscard]] int find(const QString& words, int row, bool forward) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// A row of the view, or how many follow it that are left out.
  struct Shown {
    std::uint32_t row = 0, left_out = 0;
  };
  void choose();
  [[nodiscard]] Shown shown(int row) const;
  [[nodiscard]] int modelRow(std::size_t view_row) const;
  [[nodiscard]] QString text(std::size_t view_row) const;
  [[nodiscard]] QString other(std::size_t view_row) const;

  std::shared_ptr<const EniView> view_;
  std::optional<std::vector<Shown>> chosen_;  // none: all rows
  bool only_changes_ = false;
};

}  // namespace syncline::ui
