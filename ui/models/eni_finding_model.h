// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "findings/finding.h"

namespace syncline::ui {

/// What the checker says of the lines of an ENI, the worst first.
class EniFindingModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSeverity, kLine, kRule, kFinding, kColumns };
  enum Role { kLineRole = Qt::UserRole + 1, kLevelRole };

  explicit EniFindingModel(QObject* parent = nullptr);

  void setFindings(std::vector<Finding> findings);
  [[nodiscard]] int count(Severity severity) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<Finding> findings_;
};

}  // namespace syncline::ui
