// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/link_chooser.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/text/error_text.h"
#include "ui/text/joined_text.h"
#include "ui/text/link_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

LinkChooser::LinkChooser(const Environment& environment, const QString& current, const QString& action, QWidget* parent)
    : QDialog(parent), current_(current) {
  setObjectName(QStringLiteral("linkChooser"));
  setWindowTitle(tr("Choose the Bus"));
  setMinimumSize(520, 340);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("Where is the bus?")));
  list_ = named(new QListWidget, "linkList", tr("Links"));
  list_->setIconSize(QSize(24, 24));
  list_->setSpacing(2);
  layout->addWidget(list_, 1);
  const auto& demo_link = environment.demo_link;
  addLink(demo_link, tr("Demonstration machine"),
          tr("Simulated bus with a coupler, terminals and drives; no hardware needed"), QStringLiteral("demo"));
  const bool other = !current.isEmpty() && current != demo_link && current != kMachineItself;
  if (other && current.startsWith(QLatin1String("sim:"))) {
    addLink(current, QFileInfo(current.section(u':', 1)).fileName(), tr("Simulated bus"), QStringLiteral("demo"));
  }
  note_ = new QLabel;
  note_->setWordWrap(true);
  note_->setForegroundRole(QPalette::PlaceholderText);
  addAdapters(environment.list_adapters);
  layout->addWidget(note_);
  note_->setVisible(!note_->text().isEmpty());

  buttons_ = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* accept_button = buttons_->addButton(action, QDialogButtonBox::AcceptRole);
  named(accept_button, "linkAccept", action);
  auto* open = buttons_->addButton(tr("Scenario File…"), QDialogButtonBox::ActionRole);
  named(open, "linkBrowse", tr("Simulated bus from a scenario file"));
  layout->addWidget(buttons_);
  connect(open, &QPushButton::clicked, this, &LinkChooser::browse);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
  select();
}

/// The present link, or the first one.
void LinkChooser::select() {
  list_->setCurrentRow(0);
  for (int row = 0; row < list_->count(); ++row) {
    if (list_->item(row)->data(Qt::UserRole).toString() == current_) list_->setCurrentRow(row);
  }
}

void LinkChooser::offerMachine(int slaves) {
  auto* item = addLink(kMachineItself, linkName(kMachineItself, {}),
                       tr("Simulated bus of the %n slave(s) of the project, as they are wired there", nullptr, slaves),
                       QStringLiteral("demo"));
  list_->insertItem(0, list_->takeItem(list_->row(item)));
  select();
}

QString LinkChooser::link() const {
  const auto* item = list_->currentItem();
  return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

QListWidgetItem* LinkChooser::addLink(const QString& link, const QString& title, const QString& detail,
                                      const QString& icon) {
  auto* item = new QListWidgetItem(theme::icon(icon, palette()), QStringLiteral("%1\n%2").arg(title, detail), list_);
  item->setData(Qt::UserRole, link);
  item->setData(Qt::AccessibleTextRole, QStringLiteral("%1, %2").arg(title, detail));
  if (link != kMachineItself) item->setToolTip(link);
  return item;
}

void LinkChooser::addAdapters(const AdapterLister& list_adapters) {
  const auto adapters = list_adapters ? list_adapters() : std::vector<NetworkAdapter>{};
  if (!adapters) return note_->setText(errorText(adapters.error()));
  for (const auto& adapter : *adapters) {
    QStringList facts{adapter.up ? tr("Network card, link up") : tr("Network card, no link")};
    if (!adapter.driver.isEmpty()) facts << tr("driver %1").arg(adapter.driver);
    const auto detail = joinedParts(facts);
    addLink(QStringLiteral("nic:") + adapter.name, adapter.name, detail, QStringLiteral("adapter"));
  }
  if (adapters->empty()) note_->setText(tr("No network card was found that can carry EtherCAT."));
}

void LinkChooser::browse() {
  const auto file = QFileDialog::getOpenFileName(this, tr("Open Scenario"), {}, tr("Scenarios (*.toml)"));
  if (file.isEmpty()) return;
  addLink(QStringLiteral("sim:") + file, QFileInfo(file).fileName(), tr("Simulated bus"), QStringLiteral("demo"));
  list_->setCurrentRow(list_->count() - 1);
  list_->setFocus();  // Enter takes it
}

}  // namespace syncline::ui
