// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/register_layout.h"
#include "ui/pages/online_page.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace syncline::ui {

class PollChoice;
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
  void ended() override { round_ = {}; }
  void projectChanged() override;
  void tick(std::optional<Nanoseconds> now) override;

 private:
  /// Reads that go on together: what an ESC has not is known when all have come.
  struct Round {
    std::size_t open = 0;
    std::vector<reg::RegisterRange> missing{};  // nobody processed them
    QString why{};
  };
  static constexpr int kNone = -1;

  QWidget* buildChoice();
  QWidget* buildWriting();
  void readShown();
  void readSelected();
  void read(reg::RegisterRange range);
  void take(reg::RegisterRange range, const RequestOutcome& outcome);
  void settle();
  void proveMissing();
  bool adaptUnits();
  void showSelected();
  void enableWrite();
  void write();
  void readBack(std::uint16_t address, const std::vector<std::uint8_t>& written, const QString& what);
  void complain(const QString& why);
  [[nodiscard]] QModelIndex current() const;

  RegisterModel* model_;
  RegisterFilter* filter_;
  QComboBox* group_;
  PollChoice* poll_;
  QLineEdit *words_, *value_;
  QPushButton *read_, *read_selected_, *write_;
  QTreeView* tree_;
  QWidget* writing_;
  ValueLabel* selected_;
  Round round_;
  Nanoseconds aged_ = 0;
  int selected_address_ = kNone;
  bool complained_ = false;  // of reading; no reading takes away what became of a write
};

}  // namespace syncline::ui
