// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "config/project.h"

class QComboBox;
class QLabel;

namespace syncline::ui {

class Card;
class TimeEdit;

/// What the fields show: the user's choice, and what follows from it and from the operation mode.
struct SyncUnitView {
  SyncUnitSettings settings;
  Nanoseconds bus_cycle = kMillisecond;
  Nanoseconds proposed_cycle = 0;   // of the operation mode alone
  Nanoseconds effective_cycle = 0;
  Nanoseconds effective_shift = 0;
};
/// `unit` 0 or 1.
[[nodiscard]] SyncUnitView syncUnitView(int unit, const DcOpMode& mode, const DcSlaveSettings& settings, Nanoseconds bus_cycle);

/// The fields of one SYNC unit on a card: cycle as a factor of the bus cycle or free, and shift.
class SyncUnitEditor final : public QObject {
  Q_OBJECT

 public:
  SyncUnitEditor(int unit, Card& card, QObject* parent);

  /// `enabled`: the operation mode generates this SYNC.
  void show(const SyncUnitView& view, bool enabled);

 Q_SIGNALS:
  /// Settings keys below "slave.N.dc.syncM." and their values.
  void edited(const QString& text, const QStringList& keys_and_values);

 private:
  void showOff();
  void takeChoice();
  void fillChoices(const SyncUnitView& view);

  int unit_;
  QComboBox* choice_;
  TimeEdit *cycle_, *shift_;
};

}  // namespace syncline::ui
