// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStandardItemModel>
#include <optional>
#include <vector>

#include "config/monitor_view.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// All signals that a run can show: those of the bus, of each slave, and the variables that are watched. What has no
/// value so far says so. Of the run as it is now; needs it no more afterwards.
class SignalTree final : public QStandardItemModel {
  Q_OBJECT

 public:
  explicit SignalTree(const RunRecord& record, QObject* parent = nullptr);
  /// What one may search for.
  static constexpr int kWordsRole = Qt::UserRole + 1;
  /// Nothing of a heading.
  [[nodiscard]] std::optional<ViewSignal> signalAt(const QModelIndex& index) const;

 private:
  void addSignal(QStandardItem& group, const RunRecord& record, const ViewSignal& signal, bool any);

  std::vector<ViewSignal> signals_;
};

}  // namespace syncline::ui
