// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/difference_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "settings/settings_table.h"
#include "ui/editors/number_text.h"
#include "ui/models/difference_model.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

/// "auto", "on" and the like have words, numbers their unit.
QString side(const settings::Setting& setting, const std::string& text) {
  if (text.empty()) return QStringLiteral("\u2013");
  const auto* number = std::get_if<settings::Number>(&setting.type);
  const auto unit = number != nullptr && text != setting.unset ? unitText(*number) : QString();
  return unit.isEmpty() ? settingWord(text) : QStringLiteral("%1 %2").arg(QString::fromStdString(text), unit);
}

std::vector<DifferenceModel::Line> linesOf(const RunDifference& difference, const Project& project) {
  std::vector<DifferenceModel::Line> lines;
  for (const auto& slave : difference.slaves()) {
    lines.push_back({slaveWord(),
                     QString::fromStdString(slave.slave_name),
                     slave.left_slave ? QString::number(*slave.left_slave) : QStringLiteral("\u2013"),
                     slave.right_slave ? QString::number(*slave.right_slave) : QStringLiteral("\u2013"),
                     {}});
  }
  for (const auto& one : difference.settings()) {
    const int slave = one.setting->of_slave() ? static_cast<int>(one.place.slave) : -1;
    lines.push_back({nodeName(project, slave), settingLabel(*one.setting), side(*one.setting, one.left),
                     side(*one.setting, one.right), QString::fromStdString(settings::key_of(*one.setting, one.place))});
  }
  return lines;
}

}  // namespace

DifferenceDialog::DifferenceDialog(Workspace& workspace, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("differenceDialog"));
  setWindowTitle(tr("Project and Running Machine"));
  resize(720, 360);
  auto* layout = new QVBoxLayout(this);
  auto* text = new QLabel(tr("The machine runs on as it was started. A double click goes to the field."));
  text->setWordWrap(true);
  layout->addWidget(text);
  auto* model = new DifferenceModel(linesOf(workspace.runDifference(), workspace.document().project()), tr("Runs"),
                                    tr("Project"), this);
  auto* table = named(new QTableView, "differenceTable", tr("Differences between project and running machine"));
  setUpTable(*table);
  table->setModel(model);
  table->setColumnWidth(DifferenceModel::kWhere, 180);
  table->setColumnWidth(DifferenceModel::kLeft, 150);
  table->setColumnWidth(DifferenceModel::kRight, 150);
  stretchColumn(*table, DifferenceModel::kWhat);
  layout->addWidget(table, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(table, &QTableView::activated, this, [this](const QModelIndex& index) {
    const auto key = index.data(DifferenceModel::kKeyRole).toString();
    if (key.isEmpty()) return;
    accept();
    Q_EMIT keyWanted(key);
  });
}

}  // namespace syncline::ui
