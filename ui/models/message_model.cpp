// SPDX-License-Identifier: Apache-2.0
#include "ui/models/message_model.h"

#include <QLocale>
#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/text/as_typed.h"
#include "ui/text/units.h"

namespace syncline::ui {

MessageModel::MessageModel(QObject* parent) : QAbstractTableModel(parent) {}

void MessageModel::append(Message message) {
  if (own_) {
    own_->push_front(message);
    if (own_->size() > kMaximum) own_->pop_back();
  }
  const int row = static_cast<int>(findings_.size());
  beginInsertRows({}, row, row);
  log_.push_front(std::move(message));
  endInsertRows();
  if (log_.size() > kMaximum) {
    const int last = row + static_cast<int>(log_.size()) - 1;
    beginRemoveRows({}, last, last);
    log_.pop_back();
    endRemoveRows();
  }
}

void MessageModel::setFindings(std::vector<Message> findings) {
  if (!findings_.empty()) {
    beginRemoveRows({}, 0, static_cast<int>(findings_.size()) - 1);
    findings_.clear();
    endRemoveRows();
  }
  if (findings.empty()) return;
  beginInsertRows({}, 0, static_cast<int>(findings.size()) - 1);
  findings_ = std::move(findings);
  endInsertRows();
}

void MessageModel::showOther(std::vector<Message> log) {
  if (!own_) own_ = log_;
  clearLog();
  const auto count = std::min(log.size(), kMaximum);
  if (count == 0) return;
  const int first = static_cast<int>(findings_.size());
  beginInsertRows({}, first, first + static_cast<int>(count) - 1);
  log_.assign(std::make_move_iterator(log.rbegin()),
              std::make_move_iterator(log.rbegin() + static_cast<std::ptrdiff_t>(count)));
  endInsertRows();
}

void MessageModel::showOtherUntil(const std::vector<Message>& log, std::size_t count) {
  if (!own_) return;
  const auto skipped = log.size() - std::min(log.size(), kMaximum);
  const auto wanted = std::min(count, log.size()) - std::min({count, log.size(), skipped});
  const int top = static_cast<int>(findings_.size());
  if (wanted < log_.size()) {
    const auto gone = static_cast<std::ptrdiff_t>(log_.size() - wanted);
    beginRemoveRows({}, top, top + static_cast<int>(gone) - 1);
    log_.erase(log_.begin(), log_.begin() + gone);
    endRemoveRows();
  } else if (wanted > log_.size()) {
    const auto first = skipped + log_.size();
    beginInsertRows({}, top, top + static_cast<int>(wanted - log_.size()) - 1);
    for (auto i = first; i < skipped + wanted; ++i) log_.push_front(log[i]);
    endInsertRows();
  }
}

void MessageModel::showOwn() {
  if (!own_) return;
  auto own = std::move(*own_);
  own_.reset();
  clearLog();
  if (own.empty()) return;
  const int first = static_cast<int>(findings_.size());
  beginInsertRows({}, first, first + static_cast<int>(own.size()) - 1);
  log_ = std::move(own);
  endInsertRows();
}

void MessageModel::clearLog() {
  if (log_.empty()) return;
  const int first = static_cast<int>(findings_.size());
  beginRemoveRows({}, first, first + static_cast<int>(log_.size()) - 1);
  log_.clear();
  endRemoveRows();
}

void MessageModel::setRunBegin(int run, qint64 begin) {
  begins_.insert(run, begin);
  if (const int rows = rowCount(); rows > 0)
    Q_EMIT dataChanged(index(0, kRunTime), index(rows - 1, kRunTime), {Qt::DisplayRole});
}

QString MessageModel::timeOf(const Message& message) const {
  return QLocale().toString(message.time.time(), QStringLiteral("HH:mm:ss.zzz"));
}

QString MessageModel::runTimeOf(const Message& message) const {
  const auto begin = begins_.constFind(message.run);
  return message.run == 0 || begin == begins_.cend() ? QString() : runTimeText(message.moment - *begin);
}

QString MessageModel::toolTipOf(const Message& message, int column) const {
  if (column == kTime && message.time.isValid()) {
    const auto when = QLocale().toString(message.time, QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz"));
    return message.run == kRecordedRun ? tr("%1 by the clock of the recorded run").arg(when)
                                       : tr("%1 by the clock of this computer").arg(when);
  }
  return message.key.isEmpty() ? message.text : tr("%1\nSetting %2").arg(message.text, message.key);
}

int MessageModel::count(Severity severity) const {
  const auto matches = [severity](const Message& message) { return message.severity == severity; };
  return static_cast<int>(std::ranges::count_if(findings_, matches) + std::ranges::count_if(log_, matches));
}

const Message* MessageModel::lineOf(const Finding& finding) const {
  const auto line = std::ranges::find_if(
      findings_, [&](const Message& one) { return one.finding != nullptr && *one.finding == finding; });
  return line == findings_.end() ? nullptr : &*line;
}

const Message& MessageModel::message(int row) const {
  const auto at = static_cast<std::size_t>(row);
  return at < findings_.size() ? findings_[at] : log_[at - findings_.size()];
}

int MessageModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(findings_.size() + log_.size());
}

int MessageModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant MessageModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& row = message(index.row());
  const bool finding = static_cast<std::size_t>(index.row()) < findings_.size();
  switch (role) {
    case kSeverityRole:
      return static_cast<int>(row.severity);
    case kKeyRole:
      return message(index.row()).key;
    case kSlaveRole:
      return row.slave;
    case kMomentRole:
      return row.moment;
    case kFindingRole:
      return finding;
    case Qt::ToolTipRole:
      return toolTipOf(row, index.column());
    case Qt::DisplayRole:
      break;
    default:
      return {};
  }
  switch (index.column()) {
    case kTime:
      return finding ? tr("Project") : timeOf(row);
    case kRunTime:
      return runTimeOf(row);
    case kSeverity: {
      if (row.severity == Severity::kError) return tr("Error");
      return row.severity == Severity::kWarning ? tr("Warning") : tr("Information");
    }
    case kSource:
      return row.source;
    case kText:
      return row.text;
    default:
      return {};
  }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::ToolTipRole && section == kTime) return tr("Time of day");
  if (role == Qt::ToolTipRole && section == kRunTime)
    return tr("Seconds of the run: since its first cycle, as on the axis of the plots");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kTime:
      return tr("Time");
    case kRunTime:
      return tr("Run time");
    case kSeverity:
      return tr("Severity");
    case kSource:
      return tr("Source");
    case kText:
      return tr("Message");
    default:
      return {};
  }
}

MessageFilter::MessageFilter(QObject* parent) : QSortFilterProxyModel(parent) {}

void MessageFilter::setShown(Severity severity, bool shown) {
  shown_[static_cast<int>(severity)] = shown;
  invalidateFilter();
}

void MessageFilter::setText(const QString& text) {
  text_ = asTyped(text);
  invalidateFilter();
}

bool MessageFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto cell = [&](int column) { return sourceModel()->index(row, column, parent); };
  if (!shown_[cell(0).data(MessageModel::kSeverityRole).toInt()]) return false;
  if (text_.isEmpty()) return true;
  const auto has = [&](int column) {
    return asTyped(cell(column).data().toString()).contains(text_, Qt::CaseInsensitive);
  };
  return has(MessageModel::kText) || has(MessageModel::kSource);
}

}  // namespace syncline::ui
