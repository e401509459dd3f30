// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QWidget>

#include "support/types.h"

class QPushButton;

namespace syncline::ui {

class SlaveStateCommands;
class ValueLabel;
class Workspace;

/// Below the title of a slave while the bus runs: its AL status and status code in words, a button for each state, and
/// the acknowledging of its error.
class SlaveStateBar final : public QWidget {
  Q_OBJECT

 public:
  SlaveStateBar(Workspace& workspace, SlaveStateCommands& commands, QWidget* parent = nullptr);
  /// -1: none.
  void setSlave(int slave);
  void showLive();

 private:
  /// `whole`: with the number of the state, and what to check of an error.
  [[nodiscard]] QString status(bool whole) const;
  [[nodiscard]] std::uint16_t statusNow() const;
  void ageAnswer();

  Workspace& workspace_;
  SlaveStateCommands& commands_;
  ValueLabel* text_;
  QHash<int, QPushButton*> states_;
  QPushButton* acknowledge_;
  int slave_ = -1;
  QString answer_;
  bool bad_ = false;
  int answer_position_ = -1;         // in the run, of the slave that it is about
  std::uint16_t answer_status_ = 0;  // AL status when the answer came
  Nanoseconds answer_time_ = 0;
};

}  // namespace syncline::ui
