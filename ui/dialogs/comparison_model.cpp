// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/comparison_model.h"

#include <QFont>
#include <algorithm>

#include "settings/settings_table.h"
#include "ui/editors/number_text.h"
#include "ui/session/comparison.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {
namespace {

const QString kNothing = QStringLiteral("\u2013");

/// "auto", "on" and the like have words, numbers their unit.
QString settingSide(const settings::Setting& setting, const std::string& text) {
  if (text.empty()) return kNothing;
  const auto* number = std::get_if<settings::Number>(&setting.type);
  const auto unit = number != nullptr && text != setting.unset ? unitText(*number) : QString();
  return unit.isEmpty() ? settingWord(text) : QStringLiteral("%1 %2").arg(QString::fromStdString(text), unit);
}

/// The network's values are written as programs read them.
QString networkSide(const std::string& text) {
  if (text.empty()) return kNothing;
  auto shown = QString::fromStdString(text);
  if (shown.endsWith(QLatin1String(" us"))) shown.replace(shown.size() - 2, 1, u'\u00B5');
  return shown;
}

QString groupWord(DifferenceGroup group) {
  switch (group) {
    case DifferenceGroup::kSlaves:
      return ComparisonModel::tr("Slaves");
    case DifferenceGroup::kWiring:
      return ComparisonModel::tr("Wiring");
    case DifferenceGroup::kProcessData:
      return ComparisonModel::tr("Process data");
    case DifferenceGroup::kMailbox:
      return ComparisonModel::tr("Mailbox");
    case DifferenceGroup::kStartup:
      return ComparisonModel::tr("Start-up");
    case DifferenceGroup::kClocks:
      return ComparisonModel::tr("Clocks");
    case DifferenceGroup::kCommands:
      return ComparisonModel::tr("Commands");
    case DifferenceGroup::kCyclic:
      return ComparisonModel::tr("Cyclic");
    case DifferenceGroup::kImage:
      return ComparisonModel::tr("Process image");
    case DifferenceGroup::kMaster:
      return ComparisonModel::tr("Master");
    case DifferenceGroup::kRunTime:
      break;
  }
  return ComparisonModel::tr("At run time");
}

}  // namespace

ComparisonModel::ComparisonModel(QObject* parent) : GroupedModel(parent) {}

void ComparisonModel::setCompared(const Compared& compared, const QString& left, const QString& right,
                                  std::optional<bool> project_is_left) {
  beginResetModel();
  nodes_.clear();
  changes_ = changesOf(compared.settings, compared.network);
  titles_[0] = left;
  titles_[1] = right;
  project_is_left_ = project_is_left;
  for (const auto& one : compared.settings) {
    const auto slave = one.place.slave;
    add(one, one.setting->of_slave() && slave < compared.names.size() ? compared.names[slave] : std::string());
  }
  for (const auto& one : compared.network) add(one);
  std::ranges::stable_sort(nodes_, [](const Node& x, const Node& y) {
    const auto order = [](const Node& node) { return node.left ? node.left : node.right; };
    return order(x) < order(y);
  });
  endResetModel();
}

ComparisonModel::Node& ComparisonModel::nodeOf(std::optional<std::size_t> left, std::optional<std::size_t> right,
                                               const std::string& name) {
  const auto found =
      std::ranges::find_if(nodes_, [&](const Node& node) { return node.left == left && node.right == right; });
  if (found != nodes_.end()) {
    if (found->name.isEmpty()) found->name = QString::fromStdString(name);
    return *found;
  }
  return nodes_.emplace_back(Node{left, right, QString::fromStdString(name), {}});
}

void ComparisonModel::add(const ConfigDifference& difference) {
  Line line{{findingText(difference.what), networkSide(difference.left), networkSide(difference.right),
             groupWord(difference.group)},
            findingWhole(difference.what),
            findingKey(difference.what),
            difference.group != DifferenceGroup::kImage};
  nodeOf(difference.left_slave, difference.right_slave, difference.slave_name).lines.push_back(std::move(line));
}

void ComparisonModel::add(const SettingDifference& difference, const std::string& name) {
  const auto& setting = *difference.setting;
  const auto place = setting.of_slave() ? std::optional(difference.place.slave) : std::nullopt;
  Line line{{settingLabel(setting), settingSide(setting, difference.left), settingSide(setting, difference.right),
             tr("Setting")},
            settingTip(setting),
            QString::fromStdString(settings::key_of(setting, difference.place)),
            difference.matters};
  nodeOf(place, place, name).lines.push_back(std::move(line));
}

int ComparisonModel::differences() const {
  std::size_t count = 0;
  for (const auto& node : nodes_) count += node.lines.size();
  return static_cast<int>(count);
}

int ComparisonModel::columnCount(const QModelIndex&) const { return kColumns; }

const ComparisonModel::Line* ComparisonModel::line(const QModelIndex& index) const {
  const auto member = memberOf(index);
  return member ? &nodes_[groupOf(index)].lines[*member] : nullptr;
}

int ComparisonModel::projectNode(const Node& node) const {
  if (!project_is_left_) return kNoNode;
  if (!node.left && !node.right) return -1;
  const auto& slave = *project_is_left_ ? node.left : node.right;
  return slave ? static_cast<int>(*slave) : kNoNode;
}

QVariant ComparisonModel::nodeData(const Node& node, int column, int role) const {
  if (role == Qt::FontRole) {
    QFont font;
    font.setWeight(QFont::DemiBold);
    return font;
  }
  if (role == kMattersRole) return false;  // for the sake of what is below it
  if (role != Qt::DisplayRole) return {};
  const auto position = [](const std::optional<std::size_t>& slave) {
    return slave ? tr("Position %1").arg(*slave) : kNothing;
  };
  const bool network = !node.left && !node.right;
  switch (column) {
    case kWhat:
      if (network) return tr("Network");
      return QStringLiteral("%1 %2 %3")
          .arg(slaveWord())
          .arg(node.left ? *node.left : *node.right)
          .arg(node.name)
          .trimmed();
    case kLeft:
      return network ? QString() : position(node.left);
    case kRight:
      return network ? QString() : position(node.right);
    case kKind:
      return tr("%n difference(s)", nullptr, static_cast<int>(node.lines.size()));
    default:
      return {};
  }
}

QVariant ComparisonModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto* one = line(index);
  const auto& node = nodes_[groupOf(index)];
  if (role == kNodeRole) return projectNode(node);
  if (one == nullptr) return nodeData(node, index.column(), role);
  switch (role) {
    case Qt::DisplayRole:
      return one->text[index.column()];
    case Qt::ToolTipRole:
      return one->meaning;
    case kKeyRole:
      return project_is_left_ ? one->key : QString();
    case kMattersRole:
      return one->matters;
    case kWordsRole: {
      QStringList words{nodeData(node, kWhat, Qt::DisplayRole).toString(), one->key};
      for (const auto& text : one->text) words.append(text);
      return words.join(u' ');
    }
    default:
      return {};
  }
}

QVariant ComparisonModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kWhat:
      return tr("What");
    case kLeft:
      return titles_[0];
    case kRight:
      return titles_[1];
    case kKind:
      return tr("Class");
    default:
      return {};
  }
}

}  // namespace syncline::ui
