// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace syncline::ui {

struct BlackBoxWish;

class Workspace;

/// Whether the last frames of every run are kept, where, how many, and what lies there now. OK makes it so at once.
class BlackBoxDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit BlackBoxDialog(Workspace& workspace, QWidget* parent = nullptr);
  void accept() override;

 private:
  void build();
  void browse();
  void refresh();
  void showState();
  [[nodiscard]] BlackBoxWish wish() const;

  Workspace& workspace_;
  QCheckBox* on_;
  QLineEdit* folder_;
  QPushButton *browse_, *ok_;
  QSpinBox* mib_;
  QLabel *reach_, *state_;
};

}  // namespace syncline::ui
