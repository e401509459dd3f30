// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "ui/session/eeprom_repair.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace syncline::ui {

/// Offers to end the EEPROM writes that a killed program has left half done, one after the other. Closes when none is
/// left; Later (Esc) leaves the rest for the next start.
class CutShortDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit CutShortDialog(EepromRepair& repair, QWidget* parent = nullptr);
  /// Opens when there is something to end.
  void offer();
  /// While a write runs: ends it in order first.
  void reject() override;

 Q_SIGNALS:
  /// One line for the messages.
  void told(const QString& text);

 private:
  void showFirst();
  void work(bool undo);
  void setBusy(bool busy);
  void fit();
  void onFinished();
  void onFailed(const Error& error);

  EepromRepair& repair_;
  std::vector<CutShortWrite> writes_;
  bool undo_ = false;
  QLabel *text_, *problem_;
  QProgressBar* bar_;
  QPushButton *finish_, *put_back_, *later_;
};

}  // namespace syncline::ui
