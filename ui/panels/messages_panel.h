// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "ui/text/message.h"

class QLineEdit;
class QMenu;
class QTableView;
class QToolButton;

namespace syncline::ui {

class MessageFilter;
class MessageModel;

/// The message window: findings and log with a filter; activating a row goes to its node.
class MessagesPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit MessagesPanel(MessageModel& model, QWidget* parent = nullptr);

  /// Selects the line of the event at a moment of the run; where there is none, none.
  void selectMoment(qint64 moment);
  [[nodiscard]] QSize sizeHint() const override { return {800, 128}; }

 Q_SIGNALS:
  /// What the line is about is wanted: its slave or setting, and its moment where it has one.
  void activated(const syncline::ui::Message& message);
  /// The menu of a line is about to be shown: what can be done about it is added here.
  void menuOpens(QMenu& menu, const syncline::ui::Message& message);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addSwitch(Severity severity, const char* object_name);
  void updateCounts();
  void drawIcons();
  void openMenu(const QPoint& at);

  MessageModel& model_;
  MessageFilter* filter_;
  QTableView* table_;
  QLineEdit* text_;
  QToolButton* clear_ = nullptr;
  QToolButton* switches_[3]{};
};

}  // namespace syncline::ui
