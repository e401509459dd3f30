// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QString>

class QHeaderView;
class QWidget;

namespace syncline::ui {

class WindowMemory;

/// The widths that the user gave to columns, by the name of their table: from one start to the next. What a table does
/// with its columns itself is not the user's, and stays the table's.
class ColumnMemory final : public QObject {
  Q_OBJECT

 public:
  /// Looks after all tables and trees that are in the window now.
  ColumnMemory(QWidget& window, WindowMemory& memory);
  /// As wide as at first, from now on, too.
  void reset();

 protected:
  bool eventFilter(QObject* viewport, QEvent* event) override;

 private:
  void watch(QHeaderView& header, const QString& table);
  void recall(QHeaderView& header, const QString& table);
  void note(const QHeaderView& header, const QString& table, int column);

  WindowMemory& memory_;
  QHash<QHeaderView*, QString> tables_;
  QHash<QHeaderView*, QList<int>> usual_;
  QObject* pressed_ = nullptr;  // the viewport on which the mouse button is down
};

}  // namespace syncline::ui
