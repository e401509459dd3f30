// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/process_data_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "config/module_slots.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/text_edit.h"
#include "ui/models/pdo_model.h"
#include "ui/pages/pdo_mapping_editor.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

/// Of the device or of its modules.
bool hasPdos(const SlaveSettings& slave, PdoDirection direction) {
  return !slave.device.pdos(direction).empty() || (!slave.modules.empty() && !pdos_of(slave, direction).empty());
}

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  auto font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  return label;
}

}  // namespace

ProcessDataPage::ProcessDataPage(Workspace& workspace) : Page(workspace, "processDataPage", tr("Process Data")) {
  outputs_ = new PdoModel(PdoDirection::kRx, this);
  inputs_ = new PdoModel(PdoDirection::kTx, this);
  auto* content = new QWidget;
  auto* layout = new QHBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(12);
  auto* lists = new QVBoxLayout;
  lists->setSpacing(8);
  lists->addWidget(buildDirection(outputs_, outputs_view_, outputs_size_, "outputPdos", tr("Outputs (RxPDO)")), 1);
  lists->addWidget(buildDirection(inputs_, inputs_view_, inputs_size_, "inputPdos", tr("Inputs (TxPDO)")), 1);
  layout->addLayout(lists, 1);
  layout->addWidget(buildEntries(), 1);
  setWidget(content);
}

QWidget* ProcessDataPage::buildDirection(PdoModel* model, QTableView*& view, QLabel*& size, const char* object_name,
                                         const QString& title) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->addWidget(heading(title), 1);
  size = new QLabel;
  size->setObjectName(QLatin1String(object_name) + QStringLiteral("Size"));
  size->setAccessibleName(tr("Assigned size, %1").arg(title));
  row->addWidget(size);
  layout->addLayout(row);
  view = named(new QTableView, object_name, title);
  setUpTable(*view);
  view->setModel(model);
  view->setColumnWidth(PdoModel::kIndex, 92);
  view->setColumnWidth(PdoModel::kSyncManager, 48);
  view->setColumnWidth(PdoModel::kSize, 72);
  stretchColumn(*view, PdoModel::kName);
  layout->addWidget(view, 1);
  fields().bind(*view, model == outputs_ ? "slave.N.pdo.rx" : "slave.N.pdo.tx");
  connect(model, &PdoModel::assignmentWanted, this, [this, model](const std::vector<std::uint16_t>& pdos) {
    fields().set(model == outputs_ ? "slave.N.pdo.rx" : "slave.N.pdo.tx", pdos);
  });
  connect(view->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this, model](const QModelIndex& current) {
            if (current.isValid()) showEntriesOf(model, current.row());
          });
  return area;
}

QWidget* ProcessDataPage::buildEntries() {
  mapping_ = new PdoMappingEditor(*this);
  mapping_->layout()->addWidget(buildName());
  connect(mapping_, &PdoMappingEditor::rowChanged, this, &ProcessDataPage::showMapping);
  return mapping_;
}

/// The name of the selected entry in the process image.
QWidget* ProcessDataPage::buildName() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  name_ = fields().textField("variableName", "slave.N.variable.0xIIII.K", [this] { return namedEntry(); });
  name_->setPlaceholderText(tr("As slave, PDO and entry"));
  auto* caption = new QLabel(name_->accessibleName());
  caption->setBuddy(name_);
  caption->setToolTip(name_->toolTip());
  layout->addWidget(caption);
  layout->addWidget(name_, 1);
  return area;
}

std::optional<settings::Place> ProcessDataPage::namedEntry() const {
  const int row = mapping_->row();
  if (node() < 0 || row < 0) return {};
  const settings::Place place{static_cast<std::size_t>(node()), mapping_->pdo(), static_cast<std::uint32_t>(row)};
  const auto places = settings::row("slave.N.variable.0xIIII.K").items(project(), place.slave);
  return std::ranges::find(places, place) != places.end() ? std::optional(place) : std::nullopt;
}

void ProcessDataPage::showMapping() {
  mapping_->showEntries();
  name_->setEnabled(namedEntry().has_value());
  if (!name_->isEnabled()) name_->showValue({});
  fields().refresh();
  mapping_->refreshButtons();
}

bool ProcessDataPage::appliesTo(int slave) const {
  const auto& slaves = workspace().document().project().slaves;
  if (slave < 0 || static_cast<std::size_t>(slave) >= slaves.size()) return false;
  const auto& settings = slaves[static_cast<std::size_t>(slave)];
  return hasPdos(settings, PdoDirection::kRx) || hasPdos(settings, PdoDirection::kTx);
}

void ProcessDataPage::showEntriesOf(PdoModel* model, int row) {
  const auto* pdo = model->pdo(row);
  mapping_->showPdo(pdo != nullptr ? pdo->index : std::uint16_t{0},
                    pdo == nullptr
                        ? tr("Entries")
                        : tr("Entries of %1 %2").arg(hexText(pdo->index, 4), QString::fromStdString(pdo->name)));
  auto* other = model == outputs_ ? inputs_view_ : outputs_view_;
  if (row >= 0) other->clearSelection();
  showMapping();
}

void ProcessDataPage::showPlace(const settings::Setting& setting, const settings::Place& place) {
  const bool entry = setting.key == "slave.N.variable.0xIIII.K";
  if (!entry && setting.key != "slave.N.pdo.map.0xIIII") return;
  for (auto* model : {outputs_, inputs_}) {
    for (int row = 0; row < model->rowCount(); ++row) {
      if (model->pdo(row)->index != place.item) continue;
      auto* view = model == outputs_ ? outputs_view_ : inputs_view_;
      view->setCurrentIndex(model->index(row, 0));
      showEntriesOf(model, row);
      if (entry) mapping_->selectRow(static_cast<int>(place.sub));
    }
  }
}

void ProcessDataPage::refresh() {
  const auto& slaves = workspace().document().project().slaves;
  if (node() < 0 || static_cast<std::size_t>(node()) >= slaves.size()) return;
  const auto& slave = slaves[static_cast<std::size_t>(node())];
  outputs_->setSlave(slave);
  inputs_->setSlave(slave);
  outputs_size_->setText(tr("%1 assigned").arg(bitsText(outputs_->assignedBits())));
  inputs_size_->setText(tr("%1 assigned").arg(bitsText(inputs_->assignedBits())));
  const bool outputs = outputs_->rowCount() > 0;
  outputs_view_->parentWidget()->setVisible(outputs);
  inputs_view_->parentWidget()->setVisible(inputs_->rowCount() > 0);
  showMapping();
  if (shown_node_ == node()) return;
  shown_node_ = node();
  auto* view = outputs ? outputs_view_ : inputs_view_;
  view->setCurrentIndex(view->model()->index(0, 0));
  showEntriesOf(view == outputs_view_ ? outputs_ : inputs_, 0);
}

}  // namespace syncline::ui
