// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "support/types.h"

namespace syncline {
struct DcOpMode;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

class Card;
class ChoiceEdit;
class NumberEdit;
class Page;

/// Cycle and shift of SYNC0 or SYNC1 of the slave that the page shows: the multiple of the bus cycle, a cycle of the
/// user's, or what the operation mode says.
class SyncUnitEditor final : public QObject {
  Q_OBJECT

 public:
  SyncUnitEditor(int unit, Card& card, Page& page);

  /// `mode`: null while distributed clocks are off.
  void showSlave(const SlaveSettings& slave, const DcOpMode* mode, Nanoseconds bus_cycle);

 private:
  void takeChoice();
  void fillChoices(Nanoseconds proposed, Nanoseconds bus_cycle);

  Page& page_;
  int unit_;
  ChoiceEdit* choice_;
  QString cycle_tip_;
  NumberEdit *cycle_, *shift_;
};

}  // namespace syncline::ui
