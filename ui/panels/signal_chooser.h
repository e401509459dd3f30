// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>
#include <vector>

#include "ui/plots/signal_source.h"

class QMenu;

namespace syncline::ui {

/// A menu from which up to four signals are chosen: those that have a value of their own in every cycle or reading, and
/// the deviation and the arrival phase of each slave.
class SignalChooser final : public QToolButton {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = 4;
  /// `suits`: which of them are offered.
  explicit SignalChooser(bool (*suits)(const SignalInfo&), QWidget* parent = nullptr);
  /// What the new one does not have is chosen no more. Null: nothing is offered.
  void setRecord(const RunRecord* record);
  /// The first kMost of them; changed() is told.
  void setSources(std::vector<SignalSource> sources);
  [[nodiscard]] const std::vector<SignalSource>& sources() const { return sources_; }

 Q_SIGNALS:
  void changed();

 private:
  void fill();
  void offer(QMenu& menu, const QString& text, const SignalSource& source);

  bool (*suits_)(const SignalInfo&);
  const RunRecord* record_ = nullptr;
  std::vector<SignalSource> sources_;
};

}  // namespace syncline::ui
