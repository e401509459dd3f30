// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "findings/finding.h"

namespace syncline::ui {

/// Findings, a row each: what tables of them have in common. The first column is the severity.
class FindingTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role { kLevelRole = Qt::UserRole + 1, kSlaveRole, kCodeRole, kKeyRole, kFromRole, kToRole, kLineRole };

  [[nodiscard]] int count(Severity severity) const;
  [[nodiscard]] int countFrom(Severity at_least) const;
  [[nodiscard]] const Finding& finding(int row) const { return rows_[static_cast<std::size_t>(row)]; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  using QAbstractTableModel::QAbstractTableModel;
  /// Of columns behind the severity.
  [[nodiscard]] virtual QVariant cell(const Finding& finding, int column) const = 0;
  [[nodiscard]] virtual QString heading(int column) const = 0;
  [[nodiscard]] static QString codeOf(const Finding& finding);

  std::vector<Finding> rows_;
};

}  // namespace syncline::ui
