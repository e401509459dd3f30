// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/dc_mode_model.h"

#include <utility>

#include "config/project.h"
#include "config/sync0_cycle.h"
#include "config/sync_unit_cycle.h"
#include "findings/finding.h"
#include "protocol/assign_activate.h"
#include "settings/settings_table.h"
#include "ui/text/finding_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr const char* kModeKey = "slave.N.dc.op_mode";
constexpr const char* kFactorKey = "slave.N.dc.sync0.factor";
constexpr int kMultiples[] = {1, 2, 3, 4, 5, 8, 10, 16, -2, -3, -4, -5, -8, -10, -16};

settings::Place placeOf(int row) {
  settings::Place place;
  place.slave = static_cast<std::size_t>(row);
  return place;
}

bool hasSync0(const SlaveSettings& slave) {
  const auto* mode = compiler::selected_op_mode(slave);
  return mode != nullptr && AssignActivate{mode->assign_activate}.sync0();
}

QString multipleText(int factor) {
  return factor > 0 ? QStringLiteral("\u00D7 %1").arg(factor) : QStringLiteral("/ %1").arg(-factor);
}

Nanoseconds cycleOf(const Project& project, const SlaveSettings& slave) {
  return compiler::sync_cycle(*compiler::selected_op_mode(slave), slave.dc, 0,
                              compiler::sync_unit_cycle(project.master, slave));
}

}  // namespace

DcModeModel::DcModeModel(const Project& project, Take take, QObject* parent)
    : QAbstractTableModel(parent), project_(project), take_(std::move(take)) {}

void DcModeModel::refresh(const std::vector<Finding>& findings) {
  std::vector<Note> notes(project_.slaves.size());
  for (const auto& finding : findings) {
    const auto at = static_cast<std::size_t>(finding.place.slave);
    if (finding.severity == Severity::kNote || finding.place.slave < 0 || at >= notes.size()) continue;
    const int severity = finding.severity == Severity::kError ? 2 : 1;
    if (severity > notes[at].severity) notes[at] = {findingText(finding), severity};
  }
  if (notes.size() != notes_.size()) {
    beginResetModel();
    notes_ = std::move(notes);
    return endResetModel();
  }
  notes_ = std::move(notes);
  if (!notes_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int DcModeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(notes_.size());
}

int DcModeModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant DcModeModel::textOf(int row, int column) const {
  const auto& slave = project_.slaves[static_cast<std::size_t>(row)];
  switch (column) {
    case kSlave:
      return QStringLiteral("%1  %2").arg(row).arg(QString::fromStdString(slave.name));
    case kMode:
      if (!slave.device.dc) return tr("no distributed clocks");
      return slave.dc.op_mode.empty() ? tr("Off") : QString::fromStdString(slave.dc.op_mode);
    case kFactor:
      if (!hasSync0(slave)) return noText();
      if (slave.dc.sync0.user_cycle) return tr("User defined");
      return slave.dc.sync0.cycle_factor ? multipleText(*slave.dc.sync0.cycle_factor) : tr("As operation mode");
    case kCycle:
      return hasSync0(slave) ? cycleText(cycleOf(project_, slave)) : noText();
    default:
      return notes_[static_cast<std::size_t>(row)].text;
  }
}

QVariantList DcModeModel::choices(int row, int column) const {
  QVariantList list;
  const auto add = [&list](const QString& text, const QVariant& word) {
    list.append(QVariant(QVariantList{text, word}));
  };
  const auto& slave = project_.slaves[static_cast<std::size_t>(row)];
  if (column == kMode) {
    const auto& setting = settings::row(kModeKey);
    for (const auto& option : setting.options(project_, placeOf(row)))
      add(optionText(option), QString::fromStdString(std::get<std::string>(option.value)));
    return list;
  }
  auto own = slave.dc;
  own.sync0 = {};
  const auto unit_cycle = compiler::sync_unit_cycle(project_.master, slave);
  add(tr("As operation mode (%1)")
          .arg(cycleText(compiler::sync_cycle(*compiler::selected_op_mode(slave), own, 0, unit_cycle))),
      0);
  for (const int factor : kMultiples)
    add(QStringLiteral("%1  (%2)").arg(multipleText(factor), cycleText(compiler::scaled_cycle(unit_cycle, factor))),
        factor);
  return list;
}

QVariant DcModeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || std::cmp_greater_equal(index.row(), project_.slaves.size())) return {};
  const auto& slave = project_.slaves[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(index.row(), index.column());
    case Qt::ToolTipRole:
      return index.column() == kSlave ? QVariant(QString::fromStdString(slave.device.name))
                                      : textOf(index.row(), index.column());
    case Qt::EditRole:
      return index.column() == kMode ? QVariant(QString::fromStdString(slave.dc.op_mode))
                                     : QVariant(slave.dc.sync0.cycle_factor.value_or(0));
    case kChoicesRole:
      return flags(index).testFlag(Qt::ItemIsEditable) ? choices(index.row(), index.column()) : QVariantList();
    case kSeverityRole:
      return notes_[static_cast<std::size_t>(index.row())].severity;
    default:
      return {};
  }
}

QVariant DcModeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kSlave:
      return tr("Slave");
    case kMode:
      return tr("Operation mode");
    case kFactor:
      return tr("Sync Unit Cycle");
    case kCycle:
      return tr("SYNC0");
    case kNote:
      return tr("Found");
    default:
      return {};
  }
}

Qt::ItemFlags DcModeModel::flags(const QModelIndex& index) const {
  auto flags = QAbstractTableModel::flags(index);
  if (!index.isValid() || std::cmp_greater_equal(index.row(), project_.slaves.size())) return flags;
  const auto& slave = project_.slaves[static_cast<std::size_t>(index.row())];
  const bool editable = (index.column() == kMode && slave.device.dc) || (index.column() == kFactor && hasSync0(slave));
  return editable ? flags | Qt::ItemIsEditable : flags;
}

bool DcModeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) return false;
  QString why;
  if (index.column() == kMode) {
    why = take_(kModeKey, placeOf(index.row()), value.toString().toStdString());
  } else {
    const auto factor = value.toInt();
    why = take_(kFactorKey, placeOf(index.row()),
                factor == 0 ? settings::Value{} : settings::Value{std::int64_t{factor}});
  }
  if (!why.isEmpty()) Q_EMIT refused(why);
  return why.isEmpty();
}

}  // namespace syncline::ui
