// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "ui/session/scan_controller.h"

class QLabel;
class QPushButton;

namespace syncline::ui {

class FoundModel;

/// What a scan found beside the project: nothing of it is taken over before the user says what.
class FoundDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `bus`: in words (text/link_text.h).
  FoundDialog(const Project& ours, ScanOutcome outcome, const QString& bus, QWidget* parent);

 Q_SIGNALS:
  /// The project that the user wants; `lost`: settings of it that another revision does not take.
  void wanted(const syncline::Project& project, const QStringList& lost);
  /// The machine runs and was only looked at: the user wants a full scan all the same.
  void touchWanted();

 private:
  void showChoice();
  void takeTicked();
  void replace();

  const Project ours_;
  const ScanOutcome outcome_;
  FoundModel* model_;
  QLabel* lost_;
  QPushButton* take_;
};

}  // namespace syncline::ui
