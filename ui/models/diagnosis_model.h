// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "eni/esi/diag_messages.h"
#include "protocol/diagnosis_log.h"

namespace syncline::ui {

/// The messages of a diagnosis history, newest first, with their words as far as an ESI has them.
class DiagnosisModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kPlace, kType, kState, kText, kTime, kCode, kStamp, kColumns };
  explicit DiagnosisModel(QObject* parent = nullptr);

  /// The same log again changes nothing: a selection stays while the history is polled.
  void setLog(const DiagnosisLog& log);
  void setTexts(std::vector<eni::DiagMessageText> texts);
  void clear() { setLog({}); }
  [[nodiscard]] const DiagnosisLog& log() const { return log_; }
  [[nodiscard]] int unacknowledged() const;

  /// Oldest first, with the raw values beside their words; numbers as programs read them.
  [[nodiscard]] QString csv() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] const DiagnosisEntry& entry(int row) const;
  [[nodiscard]] QString shown(const DiagnosisEntry& entry, int column) const;
  [[nodiscard]] QString textOf(const DiagnosisEntry& entry) const;
  [[nodiscard]] QString hintOf(const DiagnosisEntry& entry, int column) const;

  DiagnosisLog log_;
  std::vector<eni::DiagMessageText> texts_;
};

}  // namespace syncline::ui
