// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/pages/online_page.h"

class QLabel;
class QPushButton;
class QTableView;

namespace syncline {
struct DiagnosisLog;
}

namespace syncline::ui {

class DiagnosisModel;
class DiagnosisReader;
class DiagTextReader;
class PollChoice;

/// The diagnosis history of a slave (object 0x10F3, ETG.1020): what it has told, with the words of its ESI, and what of
/// it nobody has acknowledged yet.
class SlaveHistoryPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveHistoryPage(Workspace& workspace);

  /// Slaves with CoE.
  [[nodiscard]] bool appliesTo(int slave) const override { return speaksCoe(slave); }
  [[nodiscard]] DiagnosisModel& model() { return *model_; }

 protected:
  void slaveChanged() override;
  void ended() override;
  void tick(std::optional<Nanoseconds> now) override;
  [[nodiscard]] QString ownObstacle(const RunningSlave& slave) const override;

 private:
  QWidget* buildButtons();
  void connectReaders();
  void read();
  void showLog(const DiagnosisLog& log);
  void showSummary();
  void acknowledgeAll();
  void exportCsv();
  void enable();

  DiagnosisReader* reader_;
  DiagTextReader* texts_;
  DiagnosisModel* model_;
  QTableView* table_;
  QLabel *summary_, *flags_;
  PollChoice* poll_;
  QPushButton *read_, *acknowledge_, *export_;
  bool known_ = false;   // the history of the shown slave was read
  bool absent_ = false;  // it has none
  bool asked_ = false;   // since it is shown
  bool acknowledging_ = false;
};

}  // namespace syncline::ui
