// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <deque>
#include <optional>
#include <vector>

#include "ui/pages/online_page.h"

class QLineEdit;
class QProgressBar;
class QPushButton;

namespace syncline::ui {

class RecordModel;

/// Files of a slave (FoE), firmware among them: copied into a file here, and written from one. One at a time; it goes
/// on while another slave is looked at.
class SlaveFilesPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveFilesPage(Workspace& workspace);
  /// Slaves whose mailbox has FoE.
  [[nodiscard]] bool appliesTo(int slave) const override;
  /// The slave's file of the name in the field, into `path`: complete or not at all.
  void readInto(const QString& path);
  /// The bytes of `path` as that file, after a question.
  void writeFrom(const QString& path);

 protected:
  void slaveChanged() override;
  void machineChanged() override;
  void tick(std::optional<Nanoseconds> now) override;
  [[nodiscard]] QString ownObstacle(const RunningSlave& slave) const override;

 private:
  /// One that has begun, with the words for it.
  struct Transfer {
    std::uint16_t position = 0;  // of the slave in the run
    QString slave{};
    QString name{};  // in the slave
    QString path{};  // here
    bool writes = false;
    std::size_t bytes = 0;  // of the file here; 0 until a read one is there
  };

  QWidget* buildFields();
  void askWhereTo();
  void askWhereFrom();
  /// The password field's number; nothing, and told, where it holds none.
  std::optional<std::uint32_t> password();
  void begin(const Transfer& transfer, SlaveRequest request);
  void settle(const Transfer& transfer, const RequestOutcome& outcome);
  void note(const Transfer& transfer, const QString& became);
  void showProgress();
  void enable();

  QLineEdit *name_, *password_;
  QPushButton *read_, *write_, *cancel_;
  QProgressBar* progress_;
  RecordModel* lines_;
  std::optional<Transfer> going_;
  SlaveRequests::Id request_ = 0;
  std::deque<QStringList> done_;  // the newest first
};

}  // namespace syncline::ui
