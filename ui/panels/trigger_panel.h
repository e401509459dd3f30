// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

#include "support/types.h"
#include "trace/trigger.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QToolButton;

namespace syncline::ui {

class TriggerMonitor;

class ValueLabel;

/// The trigger, its state in words, and the list of its episodes.
class TriggerPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit TriggerPanel(TriggerMonitor& monitor, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override { return {800, 128}; }

 Q_SIGNALS:
  /// It is to be seen in the plots.
  void episodeWanted(const syncline::TriggerEpisode& episode);
  void saveWanted(syncline::Nanoseconds from, syncline::Nanoseconds to);
  void csvWanted(syncline::Nanoseconds from, syncline::Nanoseconds to);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QComboBox* choice(const char* name, const QString& accessible, const QString& tip, int characters);
  QDoubleSpinBox* number(const char* name, const QString& accessible, const QString& tip);
  void fillCodes();
  void fillSources();
  void fillSlaves();
  void fillVariables();
  void showTrigger();
  void showEpisodes();
  void enableExports();
  void takeFields();
  [[nodiscard]] Trigger fields() const;
  [[nodiscard]] QString slaveText(int slave) const;
  [[nodiscard]] QString causeText(const TriggerEpisode& episode) const;
  [[nodiscard]] const TriggerEpisode* chosen() const;

  TriggerMonitor& monitor_;
  QComboBox *source_, *slave_, *variable_, *condition_, *event_, *mode_;
  QDoubleSpinBox *level_, *low_, *high_, *pre_, *post_, *hold_off_;
  QCheckBox* magnitude_;
  QPushButton* arm_;
  ValueLabel* state_;
  QTableWidget* table_;
  QToolButton *save_, *csv_;
  bool showing_ = false;
};

}  // namespace syncline::ui
