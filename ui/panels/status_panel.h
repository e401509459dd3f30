// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <optional>

class QLabel;
class QStatusBar;

namespace syncline {
struct SlavesStanding;
}  // namespace syncline

namespace syncline::ui {

struct StateText;

class Pill;
class Workspace;

/// The fields of the status bar: link, slaves, both sync states, drift, cycle, what went wrong.
class StatusPanel final : public QObject {
  Q_OBJECT

 public:
  StatusPanel(Workspace& workspace, QStatusBar& bar);

 private:
  QLabel* addField(QStatusBar& bar, const char* object_name, const QString& accessible, const QString& tool_tip);
  Pill* addState(QStatusBar& bar, const char* object_name, const QString& accessible, const QString& tool_tip);
  void refresh();
  void showLive();
  void showRecorded();
  /// What they say of the slaves together, those included that do not answer.
  void showSlavesSync(StateText verdict, const std::optional<SlavesStanding>& standing);
  void showRecording();
  void showBlackBox();
  void showLosses(const QString& lost, const QString& late, const QString& left_out, const QString& dropped);
  void showOthers();

  Workspace& workspace_;
  qint64 shown_second_ = -1;
  QLabel *link_, *slaves_, *drift_, *cycle_, *losses_;
  Pill *phase_, *dc_, *dcm_, *recording_, *black_box_, *forced_, *others_;
};

}  // namespace syncline::ui
