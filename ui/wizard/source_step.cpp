// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/source_step.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/dialogs/link_chooser.h"
#include "ui/dialogs/questions.h"
#include "ui/dialogs/template_commands.h"
#include "ui/panels/catalogue_panel.h"
#include "ui/text/link_text.h"
#include "ui/text/menu_key.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
namespace {

enum Source : int { kScan, kEni, kCatalogue, kProject };

QLabel* sentence(const QString& text) {
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

SourceStep::SourceStep(MachineDraft& draft)
    : WizardStep(draft, "wizardSourceStep", tr("Slaves"),
                 tr("Where do the slaves come from? The list on the right shows what the new machine has so far.")) {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(16);
  layout->addWidget(buildSources());
  stack_ = new QStackedWidget;
  stack_->addWidget(buildScan());
  stack_->addWidget(buildFile("wizardChooseEni",
                              tr("A project is made of what the file lets be seen. Devices of the catalogue bring what "
                                 "an ENI does not hold."),
                              tr("Choose EN&I…"), &SourceStep::chooseEni));
  stack_->addWidget(buildCatalogue());
  stack_->addWidget(buildTemplates());
  layout->addWidget(stack_, 1);
  layout->addWidget(buildSlaves());
  setWidget(area);
  connect(sources_, &QButtonGroup::idToggled, this, [this](int source, bool on) {
    if (on) stack_->setCurrentIndex(source);
  });
  connect(&draft, &MachineDraft::told, this, [this](const QString& text, bool bad) {
    told_->setText(text);
    auto colours = told_->palette();
    colours.setColor(QPalette::WindowText,
                     bad ? theme::toneColor(palette(), theme::Tone::kBad) : theme::mutedText(palette()));
    told_->setPalette(colours);
  });
  connect(&draft, &MachineDraft::scanChanged, this, &SourceStep::showScan);
  showScan();
}

QWidget* SourceStep::buildSources() {
  auto* area = new QWidget;
  area->setFixedWidth(190);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  sources_ = new QButtonGroup(this);
  const auto add = [&](int source, const char* name, const QString& text) {
    auto* button = named(new QRadioButton(text), name, withoutMenuKey(text));
    sources_->addButton(button, source);
    layout->addWidget(button);
  };
  add(kScan, "wizardFromScan", tr("&Scan of a bus"));
  add(kEni, "wizardFromEni", tr("&ENI file"));
  add(kCatalogue, "wizardFromCatalogue", tr("&Device catalogue"));
  add(kProject, "wizardFromProject", tr("Project as a &template"));
  sources_->button(kScan)->setChecked(true);
  layout->addStretch(1);
  told_ = named(sentence({}), "wizardTold", tr("What came of it"));
  layout->addWidget(told_);
  return area;
}

QWidget* SourceStep::buildScan() {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  layout->addWidget(
      sentence(tr("A network card or a simulated bus. A bus whose slaves are running is only looked at, "
                  "and nothing is written to it.")));
  bus_ = named(sentence({}), "wizardBus", tr("Bus"));
  layout->addWidget(bus_);
  scan_ = named(new QPushButton(tr("Choose &Bus and Scan…")), "wizardScan", tr("Choose a bus and scan it"));
  cancel_ = named(new QPushButton(tr("Cance&l Scan")), "wizardCancelScan", tr("Cancel the scan"));
  fully_ = named(new QPushButton(tr("Scan &Fully…")), "wizardScanFully", tr("Scan fully"));
  looked_ = named(sentence({}), "wizardLooked", tr("Why the scan is not whole"));
  layout->addWidget(looked_);
  auto* buttons = new QHBoxLayout;
  for (auto* button : {scan_, cancel_, fully_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  layout->addLayout(buttons);
  layout->addStretch(1);
  connect(scan_, &QPushButton::clicked, this, &SourceStep::chooseBus);
  connect(cancel_, &QPushButton::clicked, &draft(), &MachineDraft::cancelScan);
  connect(fully_, &QPushButton::clicked, this, [this] {
    if (ask(*this, "touchQuestion", tr("Touch the running machine?"),
            tr("States stay as they are. EEPROMs are taken from their devices while they are read, the receive times "
               "of all slaves are latched, and slaves without a description are asked in PREOP."),
            tr("Scan Fully"))) {
      draft().scanFully();
    }
  });
  return area;
}

QWidget* SourceStep::buildCatalogue() {
  auto* panel = new CataloguePanel(draft().catalogue());
  panel->setObjectName(QStringLiteral("wizardCatalogue"));
  panel->layout()->setContentsMargins(0, 0, 0, 0);
  for (auto* button : panel->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(panel, &CataloguePanel::deviceWanted, &draft(), &MachineDraft::add);
  return panel;
}

QWidget* SourceStep::buildFile(const char* object_name, const QString& text, const QString& button,
                               void (SourceStep::*choose)()) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  layout->addWidget(sentence(text));
  auto* open = named(new QPushButton(button), object_name, withoutMenuKey(button));
  open->setAutoDefault(false);
  connect(open, &QPushButton::clicked, this, choose);
  layout->addWidget(open, 0, Qt::AlignLeft);
  layout->addStretch(1);
  return area;
}

/// The user's own, and any project file.
QWidget* SourceStep::buildTemplates() {
  auto* area =
      buildFile("wizardChooseProject", tr("All that a saved project holds, under a new name. The file stays as it is."),
                tr("Choose &Project…"), &SourceStep::chooseProject);
  auto* layout = static_cast<QVBoxLayout*>(area->layout());
  templates_ = named(new QListWidget, "wizardTemplates", tr("Your templates (File, Save as Template)"));
  auto* caption = new QLabel(tr("&Your templates (File, Save as Template)"));
  caption->setBuddy(templates_);
  use_template_ =
      named(new QPushButton(tr("&Use Template")), "wizardUseTemplate", tr("Take the slaves of the template"));
  remove_template_ = named(new QPushButton(tr("Re&move Template…")), "wizardRemoveTemplate", tr("Remove the template"));
  auto* buttons = new QHBoxLayout;
  for (auto* button : {use_template_, remove_template_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  layout->insertWidget(2, caption);
  layout->insertWidget(3, templates_, 1);
  layout->insertLayout(4, buttons);
  connect(templates_, &QListWidget::itemActivated, this, &SourceStep::takeTemplate);
  connect(templates_, &QListWidget::currentRowChanged, this, [this](int row) {
    for (auto* button : {use_template_, remove_template_}) button->setEnabled(row >= 0);
  });
  connect(use_template_, &QPushButton::clicked, this, &SourceStep::takeTemplate);
  connect(remove_template_, &QPushButton::clicked, this, &SourceStep::removeChosenTemplate);
  connect(&draft().templates(), &TemplateStore::changed, this, &SourceStep::showTemplates);
  showTemplates();
  return area;
}

QWidget* SourceStep::buildSlaves() {
  auto* area = new QWidget;
  area->setFixedWidth(250);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  count_ = named(new QLabel, "wizardSlaveCount", tr("Number of slaves"));
  layout->addWidget(count_);
  slaves_ = named(new QListWidget, "wizardSlaves", tr("Slaves of the new machine"));
  layout->addWidget(slaves_, 1);
  remove_ = named(new QPushButton(tr("&Remove")), "wizardRemove", tr("Remove the selected slave with its branches"));
  remove_->setToolTip(tr("Remove the selected slave with its branches (Del)"));
  remove_->setAutoDefault(false);
  layout->addWidget(remove_, 0, Qt::AlignLeft);
  connect(remove_, &QPushButton::clicked, this, &SourceStep::removeSelected);
  auto* key = new QShortcut(QKeySequence::Delete, slaves_);
  key->setContext(Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, this, &SourceStep::removeSelected);
  connect(slaves_, &QListWidget::currentRowChanged, this, [this](int row) { remove_->setEnabled(row >= 0); });
  return area;
}

QString SourceStep::whyNotOn() const {
  if (draft().isScanning()) return tr("The bus is being scanned.");
  return project().slaves.empty() ? tr("The machine has no slaves yet.") : QString();
}

bool SourceStep::keepsEnter() const { return stack_->isAncestorOf(window()->focusWidget()); }

QWidget* SourceStep::firstField() const { return sources_->checkedButton(); }

void SourceStep::refresh() {
  const int row = slaves_->currentRow();
  slaves_->clear();
  for (const auto& slave : project().slaves) {
    const auto& type = slave.device.type.empty() ? slave.device.name : slave.device.type;
    slaves_->addItem(QStringLiteral("%1  %2").arg(QString::fromStdString(slave.name), QString::fromStdString(type)));
    slaves_->item(slaves_->count() - 1)->setToolTip(QString::fromStdString(slave.device.name));
  }
  slaves_->setCurrentRow(std::min(row, slaves_->count() - 1));
  remove_->setEnabled(slaves_->currentRow() >= 0);
  count_->setText(tr("%n slave(s)", nullptr, slaves_->count()));
}

void SourceStep::showScan() {
  const bool scanning = draft().isScanning();
  scan_->setVisible(!scanning);
  cancel_->setVisible(scanning);
  fully_->setVisible(!scanning && draft().lookedAt() > 0);
  looked_->setVisible(!scanning && draft().lookedAt() > 0);
  looked_->setText(
      tr("%n slave(s) of this bus are running. They were only looked at and nothing was written, so some "
         "of what they are may not be known.",
         nullptr, draft().lookedAt()));
  bus_->setVisible(!draft().link().isEmpty());
  bus_->setText(tr("Scanned: %1").arg(linkName(draft().link(), workspace().environment().demo_link)));
}

void SourceStep::chooseBus() {
  const auto usual = draft().link().isEmpty() ? draft().usualLink() : draft().link();
  auto* chooser = new LinkChooser(workspace().environment(), usual, tr("Scan"), this);
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  connect(chooser, &QDialog::accepted, this, [this, chooser] { draft().scan(chooser->link()); });
  chooser->open();
}

void SourceStep::chooseEni() {
  const auto path =
      QFileDialog::getOpenFileName(this, tr("Open ENI"), {}, tr("EtherCAT network information (*.xml *.eni)"));
  if (!path.isEmpty()) draft().readEni(path);
}

void SourceStep::chooseProject() {
  const auto path = QFileDialog::getOpenFileName(this, tr("Open Project"), {}, tr("Syncline projects (*.syncline)"));
  if (!path.isEmpty()) draft().readProject(path);
}

void SourceStep::showTemplates() {
  templates_->clear();
  for (const auto& entry : draft().templates().entries()) {
    auto* item = new QListWidgetItem(entry.name, templates_);
    item->setToolTip(entry.path);
  }
  for (auto* button : {use_template_, remove_template_}) button->setEnabled(templates_->currentRow() >= 0);
}

void SourceStep::takeTemplate() {
  if (const auto* item = templates_->currentItem()) draft().readProject(item->toolTip());
}

void SourceStep::removeChosenTemplate() {
  if (const auto* item = templates_->currentItem())
    removeTemplate(*this, draft().templates(), {item->text(), item->toolTip()});
}

void SourceStep::removeSelected() {
  if (slaves_->currentRow() >= 0) draft().remove(slaves_->currentRow());
}

}  // namespace syncline::ui
