// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>
#include <vector>

#include "config/watched_variable.h"
#include "ui/plots/signal_source.h"

class QMenu;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// A menu from which up to four signals are chosen: those that have a value of their own in every cycle or reading, the
/// deviation and the arrival phase of each slave, and the variables of the process image that are watched.
class SignalChooser final : public QToolButton {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = 4;
  /// `suits`: which of them are offered.
  explicit SignalChooser(bool (*suits)(const SignalInfo&), QWidget* parent = nullptr);
  /// What the new one does not have is chosen no more. Null: nothing is offered. `recorded`: no others can be watched.
  void setRecord(const RunRecord* record, bool recorded = false);
  /// The first kMost of them; changed() is told.
  void setSources(std::vector<SignalSource> sources);
  [[nodiscard]] const std::vector<SignalSource>& sources() const { return sources_; }

 Q_SIGNALS:
  void changed();
  /// To be watched besides those that are.
  void variablesWanted();

 private:
  void fill();
  void fillVariables(QMenu& menu);
  void offer(QMenu& menu, const QString& text, const SignalSource& source);

  bool (*suits_)(const SignalInfo&);
  const RunRecord* record_ = nullptr;
  bool recorded_ = false;
  std::vector<SignalSource> sources_;
  std::vector<WatchedVariable> variables_;  // which of the sources are, in their order: numbers are of one run
};

}  // namespace syncline::ui
