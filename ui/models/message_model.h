// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QHash>
#include <QSortFilterProxyModel>
#include <deque>
#include <optional>
#include <vector>

#include "ui/text/message.h"

namespace syncline::ui {

/// The message window: the present findings about the configuration first, below them the log with
/// the newest entry on top. The log is capped; the oldest entries go first.
class MessageModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kRunTime, kSeverity, kSource, kText, kColumns };
  enum Role { kSeverityRole = Qt::UserRole + 1, kSlaveRole, kFindingRole, kKeyRole, kMomentRole };
  static constexpr std::size_t kMaximum = 5000;

  explicit MessageModel(QObject* parent = nullptr);

  void append(Message message);
  void setFindings(std::vector<Message> findings);
  /// Shows this log, newest last, in place of the own one, which goes on behind it; until showOwn().
  void showOther(std::vector<Message> log);
  /// Of that log only the first `count`: the later ones are not there yet. In steps, so that what is marked stays so.
  void showOtherUntil(const std::vector<Message>& log, std::size_t count);
  void showOwn();
  /// Empties the log; findings stay as long as they are true.
  void clearLog();
  /// Where the axis of a run begins (host clock, ns): from here on its messages say when they were in the run.
  void setRunBegin(int run, qint64 begin);
  [[nodiscard]] int count(Severity severity) const;
  /// The line of a finding about the project; null: it is none, or not any more.
  [[nodiscard]] const Message* lineOf(const Finding& finding) const;
  /// The line of a row.
  [[nodiscard]] const Message& message(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] QString timeOf(const Message& message) const;
  [[nodiscard]] QString runTimeOf(const Message& message) const;
  [[nodiscard]] QString toolTipOf(const Message& message, int column) const;

  std::vector<Message> findings_;
  std::deque<Message> log_;
  QHash<int, qint64> begins_;               // of runs
  std::optional<std::deque<Message>> own_;  // while another one is shown
};

/// Shows the chosen severities and the rows that contain a text.
class MessageFilter final : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit MessageFilter(QObject* parent = nullptr);
  void setShown(Severity severity, bool shown);
  void setText(const QString& text);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  bool shown_[3] = {true, true, true};
  QString text_;
};

}  // namespace syncline::ui
