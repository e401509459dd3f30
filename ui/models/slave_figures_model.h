// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "trace/slave_figures.h"

namespace syncline::ui {

/// Figures of all slaves' deviations, one row a slave by position; sorted by kSortRole.
class SlaveFiguresModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSlave, kNow, kAge, kMax, kMean, kRms, kOver, kMissed, kCourse, kColumns };
  /// kSortRole: numbers as numbers, what there is none of below all; kCourseRole: the largest magnitude of each part of
  /// the stretch, parts of the limit, below 0 where there is no reading.
  enum Role { kSortRole = Qt::UserRole + 1, kCourseRole };
  struct Row {
    QString name;
    ClockRole role = ClockRole::kFollower;
    SlaveFigures figures;
    QVector<float> course;
  };

  using QAbstractTableModel::QAbstractTableModel;
  /// By position; `limit` in ns, 0: none.
  void setRows(std::vector<Row> rows, double limit);
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] QString textOf(int row, int column) const;
  [[nodiscard]] QString tipOf(int row, int column) const;
  [[nodiscard]] double numberOf(int row, int column) const;
  [[nodiscard]] QColor colorOf(int row, int column) const;

  std::vector<Row> rows_;
  double limit_ = 0;
};

}  // namespace syncline::ui
