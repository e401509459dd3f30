// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/sync_unit_tree.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "settings/settings_table.h"
#include "ui/editors/page.h"
#include "ui/models/sync_unit_model.h"
#include "ui/session/project_document.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {

SyncUnitTree::SyncUnitTree(Page& page) : page_(page), model_(new SyncUnitModel(this)) {
  auto* card = new Card(tr("Slaves of the Sync Units"));
  view_ = named(new QTreeView, "unitMembers", tr("Slaves of the Sync Units"));
  view_->setToolTip(tr("Drag slaves to the Sync Unit that exchanges them"));
  view_->setModel(model_);
  setUpTree(*view_);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setDragDropMode(QAbstractItemView::InternalMove);
  view_->header()->setSectionResizeMode(SyncUnitModel::kSlave, QHeaderView::Stretch);
  view_->header()->setSectionResizeMode(SyncUnitModel::kData, QHeaderView::ResizeToContents);
  view_->header()->setStretchLastSection(false);
  view_->setMinimumHeight(220);  // the page scrolls
  button_ = named(new QToolButton, "unitMove", tr("Move to Sync Unit"));
  button_->setText(tr("Move to"));
  button_->setToolTip(tr("Give the selected slaves to a Sync Unit"));
  button_->setPopupMode(QToolButton::InstantPopup);
  button_->setMenu(new QMenu(button_));
  card->addWide(view_);
  card->addWide(button_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(card);
  connect(button_->menu(), &QMenu::aboutToShow, this, &SyncUnitTree::fillMenu);
  connect(model_, &SyncUnitModel::moveWanted, this, &SyncUnitTree::move);
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { button_->setEnabled(!selected().empty()); });
}

std::vector<UnitMember> SyncUnitTree::selected() const {
  std::vector<UnitMember> members;
  for (const auto& index : view_->selectionModel()->selectedRows()) {
    if (const auto* member = model_->member(index)) members.push_back(*member);
  }
  return members;
}

void SyncUnitTree::fillMenu() {
  auto* menu = button_->menu();
  menu->clear();
  for (int row = 0; row < model_->rowCount(); ++row) {
    const auto index = model_->index(row, 0);
    menu->addAction(index.data().toString(), this, [this, unit = model_->unit(index)] { move(selected(), unit); });
  }
}

void SyncUnitTree::move(const std::vector<UnitMember>& members, const QString& unit) {
  std::vector<SettingEdit> edits;
  const auto put = [&](const UnitMember& member, const char* key) {
    SettingEdit edit{&settings::row(key), {.slave = static_cast<std::size_t>(member.slave)}, {}};
    edit.value.emplace<std::string>(unit.toStdString());
    edits.push_back(std::move(edit));
  };
  for (const auto& member : members) {
    if (member.outputs) put(member, "slave.N.sync_unit.outputs");
    if (member.inputs) put(member, "slave.N.sync_unit.inputs");
  }
  if (!edits.empty()) page_.set(tr("Move to Sync Unit"), std::move(edits));
}

/// The selection goes with the slaves.
void SyncUnitTree::refresh() {
  const auto before = selected();
  model_->setProject(page_.project());
  setVisible(model_->rowCount() > 1);
  view_->expandAll();
  QItemSelection selection;
  for (const auto& member : before) {
    for (const auto& index : model_->find(member.address)) selection.select(index, index);
  }
  view_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  button_->setEnabled(!selected().empty());
}

}  // namespace syncline::ui
