// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "findings/finding.h"

namespace syncline::ui {

/// The findings about the running bus, most severe first. Rows that stay keep their place and selection.
class FindingModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSeverity, kWhere, kFinding, kAdvice, kColumns };
  enum Role { kLevelRole = Qt::UserRole + 1, kSlaveRole, kCodeRole, kKeyRole, kFromRole, kToRole };

  explicit FindingModel(QObject* parent = nullptr);
  void setFindings(const std::vector<Finding>& findings);
  [[nodiscard]] int count(Severity at_least) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void put(int row, const Finding& finding);

  std::vector<Finding> rows_;
};

}  // namespace syncline::ui
