// SPDX-License-Identifier: Apache-2.0
#include "ui/models/variable_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <utility>

#include "config/image_owners.h"
#include "config/network_config.h"
#include "protocol/coe_data_type.h"
#include "support/bits.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

VariableModel::Row rowOf(const Variable& variable, bool output, std::optional<std::size_t> slave) {
  VariableModel::Row row{variable.bit_offset, output, slave, QString::fromStdString(variable.comment)};
  row.entry.name = QString::fromStdString(variable.name);
  row.entry.bits = static_cast<std::uint16_t>(std::min<std::uint32_t>(variable.bit_size, 0xFFFF));
  row.entry.type_name = QString::fromStdString(variable.data_type);
  // A type that is as long as what is mapped; of another length, and of types of the device's own, there are bytes.
  const auto* type = coe::find_data_type(variable.data_type);
  if (type != nullptr && (type->bits == 0 || type->bits == variable.bit_size)) row.entry.type = type->code;
  return row;
}

}  // namespace

std::vector<std::uint8_t> bitsOf(std::span<const std::uint8_t> image, std::uint32_t offset, std::uint32_t count) {
  if ((std::uint64_t{offset} + count + 7) / 8 > image.size()) return {};
  std::vector<std::uint8_t> bytes((count + 7) / 8);
  copy_bits(bytes, 0, image, offset, count);
  return bytes;
}

VariableModel::VariableModel(QObject* parent) : QAbstractTableModel(parent) {}

void VariableModel::setVariables(const NetworkConfig& config, std::optional<std::size_t> slave) {
  const ImageOwners owners(config);
  std::vector<Row> rows;
  const auto add = [&](const std::vector<Variable>& variables, bool output) {
    for (const auto& variable : variables) {
      const auto owner = output ? owners.of_output(variable.bit_offset) : owners.of_input(variable.bit_offset);
      if (!slave || owner == slave) rows.push_back(rowOf(variable, output, owner));
    }
  };
  add(config.image.inputs, false);
  add(config.image.outputs, true);
  if (rows == rows_) return;
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

void VariableModel::clear() {
  if (rows_.empty()) return;
  beginResetModel();
  rows_.clear();
  endResetModel();
}

void VariableModel::setImage(const ImageContents* image, const std::vector<bool>& silent) {
  if (image == nullptr && !image_) return;
  if (image != nullptr && image_ && image->cycle == image_->cycle && image->time == image_->time && silent == silent_)
    return;
  const bool other = !image_ || image == nullptr || !std::ranges::equal(image_->forced(), image->forced());
  if (image == nullptr) {
    image_.reset();
  } else {
    image_ = *image;
  }
  silent_ = silent;
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, kValue), index(rowCount() - 1, kForced));
  if (other) Q_EMIT forcesChanged();
}

const VariableModel::Row* VariableModel::row(int row) const {
  return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)] : nullptr;
}

/// Outputs are the master's own. Inputs that do not come back, and those of a slave that is silent, are what they were
/// when they were read last.
bool VariableModel::known(const Row& row) const {
  if (!image_) return false;
  if (row.output) return true;
  if (row.slave && *row.slave < silent_.size() && silent_[*row.slave]) return false;
  const auto marks = bitsOf(image_->known(), row.bit_offset / 8 * 8, row.bit_offset % 8 + row.entry.bits);
  return !marks.empty() && std::ranges::all_of(marks, [](std::uint8_t byte) { return byte != 0; });
}

std::vector<std::uint8_t> VariableModel::value(int row) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  if (!known(one)) return {};
  return bitsOf(one.output ? image_->outputs() : image_->inputs(), one.bit_offset, one.entry.bits);
}

bool VariableModel::forced(int row) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  if (!one.output || !image_) return false;
  return std::ranges::any_of(bitsOf(image_->forced(), one.bit_offset, one.entry.bits),
                             [](std::uint8_t bits) { return bits != 0; });
}

void VariableModel::setWatched(std::set<QString> inputs, std::set<QString> outputs) {
  if (inputs == watched_inputs_ && outputs == watched_outputs_) return;
  watched_inputs_ = std::move(inputs);
  watched_outputs_ = std::move(outputs);
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, kMonitor), index(rowCount() - 1, kMonitor));
}

bool VariableModel::watched(int row) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  return (one.output ? watched_outputs_ : watched_inputs_).contains(one.entry.name);
}

int VariableModel::unknownInputs() const {
  return static_cast<int>(std::ranges::count_if(rows_, [this](const Row& row) { return !row.output && !known(row); }));
}

int VariableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int VariableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant VariableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[kColumns] = {tr("Variable"), tr("Direction"), tr("Type"),   tr("Place"),
                                    tr("Value"),    tr("Hex"),       tr("Forced"), tr("Monitor")};
  return titles[section];
}

QString VariableModel::text(int row, int column) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  switch (column) {
    case kName:
      return one.entry.name;
    case kDirection:
      return one.output ? tr("Output") : tr("Input");
    case kType:
      return one.entry.type_name.isEmpty() ? bitsText(one.entry.bits) : one.entry.type_name;
    case kPlace:
      return QStringLiteral("%1.%2").arg(one.bit_offset / 8).arg(one.bit_offset % 8);
    case kValue: {
      const auto bytes = value(row);
      return bytes.empty() ? noText() : valueText(one.entry, bytes);
    }
    case kRaw: {
      const auto bytes = value(row);
      return bytes.empty() ? QString() : rawText(one.entry, bytes);
    }
    case kForced:
      return forced(row) ? tr("forced") : QString();
    case kMonitor:
      return watched(row) ? tr("watched") : QString();
    default:
      return {};
  }
}

QString VariableModel::toolTip(int row) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  QStringList lines{one.entry.name};
  if (!one.comment.isEmpty()) lines << one.comment;
  lines << tr("%1, byte %2 bit %3 of the process image's %4")
               .arg(bitsText(one.entry.bits))
               .arg(one.bit_offset / 8)
               .arg(one.bit_offset % 8)
               .arg(one.output ? tr("outputs") : tr("inputs"));
  if (image_ && !known(one))
    lines << tr("Not known: it does not come back, or its slave does not exchange process data.");
  return lines.join(u'\n');
}

QVariant VariableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const int row = index.row();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return text(row, index.column());
    case Qt::ToolTipRole:
      return toolTip(row);
    case Qt::TextAlignmentRole:
      if (index.column() == kValue || index.column() == kPlace) return int{Qt::AlignRight | Qt::AlignVCenter};
      return {};
    case Qt::FontRole:
      if (index.column() >= kValue && index.column() <= kForced && forced(row)) {
        QFont font;
        font.setBold(true);
        return font;
      }
      return {};
    case Qt::ForegroundRole:
      if (index.column() >= kValue && index.column() <= kForced && forced(row))
        return theme::toneColor(QGuiApplication::palette(), theme::Tone::kWarning);
      return {};
    case kWordsRole:
      return text(row, kName) + u' ' + text(row, kType) + u' ' + text(row, kPlace);
    case kOutputRole:
      return rows_[static_cast<std::size_t>(row)].output;
    case kForcedRole:
      return forced(row);
    default:
      return {};
  }
}

}  // namespace syncline::ui
