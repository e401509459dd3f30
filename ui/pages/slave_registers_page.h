// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/pages/online_page.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace syncline::ui {

class RegisterFilter;
class RegisterModel;
class ValueLabel;

/// The registers of a slave's ESC by their names and bits, read on demand or again and again; written by experts.
class SlaveRegistersPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveRegistersPage(Workspace& workspace);
  [[nodiscard]] RegisterModel& model() { return *model_; }

 protected:
  void slaveChanged() override;
  void projectChanged() override;
  void tick(const Snapshot& snapshot, const QString& obstacle) override;

 private:
  QWidget* buildChoice();
  QWidget* buildWriting();
  void readShown();
  void readSelected();
  void read(std::uint16_t address, std::uint16_t length);
  void take(std::uint16_t address, std::uint16_t length, const RequestOutcome& outcome);
  void adaptUnits();
  void showSelected();
  void write();
  void say(const QString& text, bool bad = false);
  [[nodiscard]] QModelIndex current() const;

  RegisterModel* model_;
  RegisterFilter* filter_;
  QComboBox *group_, *poll_;
  QLineEdit *words_, *value_;
  QPushButton *read_, *read_selected_, *write_;
  QTreeView* tree_;
  QWidget* writing_;
  ValueLabel *status_, *selected_;
  std::size_t waiting_ = 0;
  Nanoseconds polled_ = 0, aged_ = 0;
  bool possible_ = false;
};

}  // namespace syncline::ui
