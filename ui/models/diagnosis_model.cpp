// SPDX-License-Identifier: Apache-2.0
#include "ui/models/diagnosis_model.h"

#include <QDateTime>
#include <QFont>
#include <QGuiApplication>
#include <QLocale>
#include <algorithm>
#include <utility>

#include "protocol/coe.h"
#include "protocol/diagnosis_text.h"
#include "protocol/object_value.h"
#include "support/csv_field.h"
#include "ui/models/dictionary.h"
#include "ui/text/event_text.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

using DiagType = DiagnosisMessage::Type;

/// No network's clock says a time in the DC epoch's first year: those are counted from when the device was switched on,
/// or by a clock that nobody has set.
constexpr std::uint64_t kNoCalendarBefore = 365ULL * 86'400 * 1'000'000'000, kNoCalendarFrom = 1ULL << 63;

QString typeText(DiagType type) {
  switch (type) {
    case DiagType::kInfo:
      return DiagnosisModel::tr("Information");
    case DiagType::kWarning:
      return DiagnosisModel::tr("Warning");
    case DiagType::kError:
      return DiagnosisModel::tr("Error");
  }
  return hexText(static_cast<unsigned>(type), 1);
}

QString timeOf(std::uint64_t stamp) {
  if (stamp == 0 || stamp >= kNoCalendarFrom) return noText();
  if (stamp < kNoCalendarBefore) {
    return DiagnosisModel::tr("%1 s since its start").arg(QLocale().toString(static_cast<double>(stamp) / 1e9, 'f', 3));
  }
  return dateTimeOf(static_cast<Nanoseconds>(stamp)).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz"));
}

}  // namespace

DiagnosisModel::DiagnosisModel(QObject* parent) : QAbstractTableModel(parent) {}

void DiagnosisModel::setLog(const DiagnosisLog& log) {
  if (log == log_) return;
  if (log.entries == log_.entries) {
    log_.header = log.header;
    if (!log_.entries.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  log_ = log;
  endResetModel();
}

void DiagnosisModel::setTexts(std::vector<eni::DiagMessageText> texts) {
  texts_ = std::move(texts);
  if (!log_.entries.empty()) Q_EMIT dataChanged(index(0, kText), index(rowCount() - 1, kText));
}

int DiagnosisModel::unacknowledged() const {
  return static_cast<int>(std::ranges::count_if(
      log_.entries, [this](const DiagnosisEntry& one) { return !log_.header.acknowledged(one.sub_index); }));
}

int DiagnosisModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(log_.entries.size());
}

int DiagnosisModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

const DiagnosisEntry& DiagnosisModel::entry(int row) const {
  return log_.entries[log_.entries.size() - 1 - static_cast<std::size_t>(row)];
}

QString DiagnosisModel::textOf(const DiagnosisEntry& one) const {
  const auto& message = *one.message;
  const auto* known = eni::find_text(texts_, message.text_id);
  return QString::fromStdString(known == nullptr || known->text.empty() ? raw_diagnosis_text(message)
                                                                        : diagnosis_text(known->text, message));
}

QString DiagnosisModel::shown(const DiagnosisEntry& one, int column) const {
  if (column == kPlace) return hexText(one.sub_index, 2);
  if (column == kState) return log_.header.acknowledged(one.sub_index) ? tr("Acknowledged") : tr("New");
  if (!one.message) {
    return column == kText ? tr("cannot be read: %1").arg(QString::fromStdString(value_text(kBytesType, one.bytes)))
                           : noText();
  }
  switch (column) {
    case kType:
      return typeText(one.message->type);
    case kText:
      return textOf(one);
    case kCode:
      return hexText(one.message->code, 8);
    case kTime:
      return timeOf(one.message->time_stamp);
    case kStamp:
      return one.message->time_stamp == 0 ? noText() : QString::number(one.message->time_stamp);
    default:
      return {};
  }
}

QString DiagnosisModel::hintOf(const DiagnosisEntry& one, int column) const {
  if (column == kPlace) return objectText({diagnosis_history::kIndex, one.sub_index});
  if (column != kText || !one.message) return {};
  const auto* known = eni::find_text(texts_, one.message->text_id);
  QStringList lines{textOf(one)};
  if (known != nullptr && !known->description.empty()) lines << QString::fromStdString(known->description);
  lines << tr("Text %1 of the ESI").arg(hexText(one.message->text_id, 4));
  return lines.join(u'\n');
}

QVariant DiagnosisModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& one = entry(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return shown(one, index.column());
    case Qt::ToolTipRole:
      return hintOf(one, index.column());
    case Qt::FontRole: {
      const bool tells = index.column() == kText || index.column() == kState;
      if (!tells || log_.header.acknowledged(one.sub_index)) return {};
      auto font = QGuiApplication::font();
      font.setWeight(QFont::DemiBold);
      return font;
    }
    case Qt::ForegroundRole: {
      if (index.column() != kType || !one.message || one.message->type == DiagType::kInfo) return {};
      const auto tone = one.message->type == DiagType::kError ? theme::Tone::kBad : theme::Tone::kWarning;
      return theme::toneColor(QGuiApplication::palette(), tone);
    }
    case Qt::TextAlignmentRole:
      if (index.column() == kStamp) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
      return {};
    default:
      return {};
  }
}

QVariant DiagnosisModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kPlace:
      return tr("Sub-index");
    case kType:
      return tr("Severity");
    case kText:
      return tr("Message");
    case kCode:
      return tr("Diag code");
    case kTime:
      return tr("Time");
    case kStamp:
      return tr("DC time (ns)");
    case kState:
      return tr("State");
    default:
      return {};
  }
}

QString DiagnosisModel::csv() const {
  const auto line = [](const QStringList& cells) {
    QStringList fields;
    for (const auto& cell : cells) fields << QString::fromStdString(csv_field(cell.toStdString()));
    return fields.join(u',') + u'\n';
  };
  auto out = line({tr("Sub-index"), tr("State"), tr("Severity"), tr("Diag code"), tr("Text ID"), tr("Message"),
                   tr("DC time (ns)"), tr("Time")});
  for (const auto& one : log_.entries) {
    QStringList cells{shown(one, kPlace), shown(one, kState)};
    if (!one.message) {
      cells << QStringList{{}, {}, {}, shown(one, kText), {}, {}};
    } else {
      const auto stamp = one.message->time_stamp;
      const bool dated = stamp >= kNoCalendarBefore && stamp < kNoCalendarFrom;
      cells << typeText(one.message->type) << shown(one, kCode) << hexText(one.message->text_id, 4) << textOf(one)
            << QString::number(stamp)
            << (dated ? dateTimeOf(static_cast<Nanoseconds>(stamp)).toString(Qt::ISODateWithMs) : QString());
    }
    out += line(cells);
  }
  return out;
}

}  // namespace syncline::ui
