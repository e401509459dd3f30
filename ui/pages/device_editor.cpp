// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/device_editor.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "settings/settings_table.h"
#include "ui/dialogs/slave_state_commands.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/field_menu.h"
#include "ui/pages/eni_page.h"
#include "ui/pages/frames_page.h"
#include "ui/pages/init_commands_page.h"
#include "ui/pages/master_dc_expert_page.h"
#include "ui/pages/master_dc_page.h"
#include "ui/pages/master_general_page.h"
#include "ui/pages/master_tasks_page.h"
#include "ui/pages/process_data_page.h"
#include "ui/pages/slave_counters_page.h"
#include "ui/pages/slave_data_page.h"
#include "ui/pages/slave_dc_page.h"
#include "ui/pages/slave_eeprom_page.h"
#include "ui/pages/slave_files_page.h"
#include "ui/pages/slave_general_page.h"
#include "ui/pages/slave_history_page.h"
#include "ui/pages/slave_mailbox_page.h"
#include "ui/pages/slave_modules_page.h"
#include "ui/pages/slave_objects_page.h"
#include "ui/pages/slave_registers_page.h"
#include "ui/pages/slave_startup_page.h"
#include "ui/pages/slave_sync_page.h"
#include "ui/pages/slave_timing_page.h"
#include "ui/pages/variables_page.h"
#include "ui/panels/slave_state_bar.h"
#include "ui/session/running_slave.h"
#include "ui/session/window_memory.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

const QString kPagesShown = QStringLiteral("pages/shown");

}  // namespace

DeviceEditor::DeviceEditor(Workspace& workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  setObjectName(QStringLiteral("deviceEditor"));
  setAccessibleName(tr("Device editor"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* header = new QHBoxLayout;
  header->setContentsMargins(14, 8, 14, 6);
  header->setSpacing(12);
  auto* title = new ValueLabel;
  title->setLeastCharacters(12);
  title_ = title;
  title_->setObjectName(QStringLiteral("nodeTitle"));
  auto font = title_->font();
  font.setPointSizeF(font.pointSizeF() * 1.2);
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  subtitle_ = new ValueLabel;
  subtitle_->setLeastCharacters(12);
  subtitle_->setForegroundRole(QPalette::PlaceholderText);
  state_ = new Pill;
  state_->setObjectName(QStringLiteral("nodeState"));
  state_->setAccessibleName(tr("State of the selected node"));
  header->addWidget(title_);
  header->addWidget(subtitle_, 1);
  modes_ = buildModes();
  header->addWidget(modes_);
  header->addWidget(state_);
  layout->addLayout(header);
  commands_ = new SlaveStateCommands(workspace, *this, this);
  state_bar_ = new SlaveStateBar(workspace, *commands_);
  layout->addWidget(state_bar_);
  tabs_ = new QTabWidget;
  tabs_->setObjectName(QStringLiteral("deviceTabs"));
  tabs_->setAccessibleName(tr("Pages of the selected node"));
  tabs_->setDocumentMode(true);
  layout->addWidget(tabs_, 1);
  auto* eni = new EniPage(workspace);
  connect(eni, &EniPage::compareWanted, this, &DeviceEditor::compareWanted);
  connect(eni, &EniPage::exportWanted, this, &DeviceEditor::exportWanted);
  connect(eni, &EniPage::findingMenuOpens, this, &DeviceEditor::findingMenuOpens);
  objects_ = new SlaveObjectsPage(workspace);
  pages_ = {new MasterGeneralPage(workspace),
            new MasterDcPage(workspace),
            new MasterDcExpertPage(workspace),
            new MasterTasksPage(workspace),
            new SlaveGeneralPage(workspace),
            new SlaveDcPage(workspace),
            new SlaveSyncPage(workspace),
            new SlaveModulesPage(workspace),
            new ProcessDataPage(workspace),
            new SlaveDataPage(workspace),
            new SlaveStartupPage(workspace),
            new SlaveMailboxPage(workspace),
            new SlaveTimingPage(workspace),
            objects_,
            new SlaveRegistersPage(workspace),
            new SlaveEepromPage(workspace),
            new SlaveFilesPage(workspace),
            new SlaveCountersPage(workspace),
            new SlaveHistoryPage(workspace),
            new VariablesPage(workspace),
            new FramesPage(workspace),
            new InitCommandsPage(workspace),
            eni};
  for (auto* page : pages_) {
    page->setParent(this);
    page->hide();
    connect(&page->fields(), &FieldBinder::eniWanted, this, &DeviceEditor::showInEni);
  }
  eni_ = eni;
  buildEniKey();
  // Before any selection changes: what is typed belongs to slaves that may be others now.
  connect(&workspace.document(), &ProjectDocument::slavesReplaced, this, [this] {
    revertFields();
    // Others hear of the new slaves earlier and have this refreshed: a slave that is gone is shown no more.
    if (slave_ >= static_cast<int>(workspace_.document().project().slaves.size())) slave_ = -1;
  });
  connect(&workspace.document(), &ProjectDocument::projectChanged, this, [this](bool structural) {
    const auto count = static_cast<int>(workspace_.document().project().slaves.size());
    if (slave_ >= count) slave_ = -1;
    if (structural) return showNode(slave_);
    chooseTabs();
    refresh();
  });
  connect(&workspace, &Workspace::projectFindingsChanged, this, &DeviceEditor::showNotes);
  connect(&workspace, &Workspace::expertChanged, this, [this] {
    // A field that is edited stays; here it is the switch that takes it away.
    if (isAncestorOf(QApplication::focusWidget())) tabs_->setFocus();
    showNode(slave_);
  });
  connect(&workspace.configuration(), &ConfigurationMonitor::compiled, this, &DeviceEditor::refresh);
  connect(&workspace.live(), &LiveSession::snapshotChanged, this, &DeviceEditor::showLive);
  connect(&workspace.live(), &LiveSession::phaseChanged, this, &DeviceEditor::showLive);
  showNode(-1);
}

Segments* DeviceEditor::buildModes() {
  const auto key = [](Qt::Key digit) { return QKeySequence(Qt::CTRL | Qt::ALT | digit); };
  auto* modes = named(
      new Segments({{"pagesAll", tr("All"), tr("All pages of the selected node"), key(Qt::Key_7)},
                    {"pagesConfiguration", tr("Configuration"), tr("The pages that say what shall be"), key(Qt::Key_8)},
                    {"pagesDiagnosis", tr("Diagnosis"), tr("The pages that show what is"), key(Qt::Key_9)}}),
      "deviceModes", tr("Which pages are shown"));
  connect(modes, &Segments::chosen, this, [this](int mode) { setMode(static_cast<Mode>(mode)); });
  const int remembered = workspace_.memory().value(kPagesShown).toInt();
  mode_ = static_cast<Mode>(std::clamp(remembered, 0, static_cast<int>(Mode::kDiagnosis)));
  modes->setCurrent(static_cast<int>(mode_));
  return modes;
}

/// For the field that has the focus.
void DeviceEditor::buildEniKey() {
  auto* show = new QAction(showInEniText(), this);
  show->setObjectName(QStringLiteral("actionShowInEni"));
  show->setShortcut(kShowInEniKey);
  show->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(show);
  connect(show, &QAction::triggered, this, [this] {
    for (const auto* page : pages_) {
      const auto key = page->fields().keyOf(QApplication::focusWidget());
      if (!key.isEmpty()) return showInEni(key);
    }
  });
}

void DeviceEditor::showInEni(const QString& key) {
  if (!commitFields()) return;
  reveal(eni_);
  eni_->showDependents(key);
}

const QList<QAction*>& DeviceEditor::modeActions() const { return modes_->choices(); }

void DeviceEditor::setMode(Mode mode) {
  if (mode != mode_ && commitFields()) {
    mode_ = mode;
    workspace_.memory().setValue(kPagesShown, static_cast<int>(mode));
    chooseTabs();
  }
  modes_->setCurrent(static_cast<int>(mode_));
}

bool DeviceEditor::isShown(const Page& page) const {
  const auto purpose = page.purpose();
  if (mode_ == Mode::kAll || purpose == PagePurpose::kBoth) return true;
  return (mode_ == Mode::kDiagnosis) == (purpose == PagePurpose::kDiagnosis);
}

void DeviceEditor::reveal(Page* page) {
  if (!isShown(*page)) setMode(Mode::kAll);
  if (tabs_->indexOf(page) >= 0) tabs_->setCurrentWidget(page);
}

void DeviceEditor::showNode(int slave) {
  if (const auto* now = static_cast<Page*>(tabs_->currentWidget()))
    (slave_ < 0 ? front_of_master_ : front_of_slaves_) = now->title();
  const bool other_kind = (slave < 0) != (slave_ < 0);
  slave_ = slave;
  for (auto* page : pages_) {
    if (page->appliesTo(slave)) page->setNode(slave);
  }
  chooseTabs(other_kind ? (slave < 0 ? front_of_master_ : front_of_slaves_) : QString());
  refresh();
  state_bar_->setSlave(slave);
  showLive();
}

bool DeviceEditor::showKey(const QString& key) {
  const auto ref = settings::find(workspace_.document().project(), key.toStdString(), false);
  if (!ref) return false;
  const int node = ref->setting->of_slave() ? static_cast<int>(ref->place.slave) : -1;
  if (node != slave_) Q_EMIT nodeWanted(node);
  const bool before = workspace_.expert();
  for (const bool expert : {before, true}) {
    workspace_.setExpert(expert);
    for (auto* page : pages_) {
      if (!page->appliesTo(node)) continue;
      page->showPlace(*ref->setting, ref->place);
      auto* field = page->fields().fieldOf(*ref->setting, ref->place);
      if (field == nullptr) continue;
      reveal(page);
      page->ensureWidgetVisible(field, 50, 80);
      field->setFocus(Qt::OtherFocusReason);
      return true;
    }
    if (before) return false;
  }
  workspace_.setExpert(before);
  return false;
}

void DeviceEditor::showPage(const char* object_name) {
  for (auto* page : pages_) {
    if (page->appliesTo(slave_) && page->objectName() == QLatin1String(object_name)) reveal(page);
  }
}

void DeviceEditor::showObject(coe::ObjectAddress object) {
  if (!objects_->appliesTo(slave_)) return;
  reveal(objects_);
  objects_->showObject(object);
}

/// What is found wrong with a setting stands beside its field.
void DeviceEditor::showNotes() {
  const auto notes = notesOf(workspace_.settingFindings(), workspace_.document().project());
  for (auto* page : pages_) {
    if (page->appliesTo(slave_)) page->fields().showNotes(notes);
  }
}

bool DeviceEditor::commitFields() {
  bool taken = true;
  for (auto* page : pages_) taken = page->fields().commit() && taken;
  return taken;
}

void DeviceEditor::revertFields() {
  for (auto* page : pages_) page->fields().revert();
}

/// `front`: the page to bring there, by its title; where there is none, the same kind of page stays, and so does one
/// that master and slaves have alike.
void DeviceEditor::chooseTabs(QString front) {
  QList<Page*> wanted;
  for (auto* page : pages_) {
    if (!page->appliesTo(slave_) || !isShown(*page)) continue;
    if (page->node() != slave_) page->setNode(slave_);  // it did not apply before
    wanted.append(page);
  }
  QList<Page*> shown;
  for (int i = 0; i < tabs_->count(); ++i) shown.append(static_cast<Page*>(tabs_->widget(i)));
  if (shown == wanted) return;
  // A page that goes takes the focus with it: what is typed next is for no field of the one that comes.
  auto* now = static_cast<Page*>(tabs_->currentWidget());
  if (now != nullptr && !wanted.contains(now) && now->isAncestorOf(window()->focusWidget())) tabs_->setFocus();
  const bool known = std::ranges::find(wanted, front, &Page::title) != wanted.end();
  if (now != nullptr && (!known || wanted.contains(now))) front = now->title();
  // What comes before what goes: each page that is taken away from the front would bring the next one there, laid out.
  int place = 0;
  for (auto* page : wanted) {
    if (tabs_->indexOf(page) < 0) tabs_->insertTab(place, page, page->title());
    place = tabs_->indexOf(page) + 1;
    if (page->title() == front) tabs_->setCurrentWidget(page);
  }
  if (!wanted.contains(tabs_->currentWidget())) tabs_->setCurrentWidget(wanted.value(0));
  for (auto* page : shown) {
    if (!wanted.contains(page)) tabs_->removeTab(tabs_->indexOf(page));
  }
}

void DeviceEditor::refresh() {
  const auto& project = workspace_.document().project();
  title_->setText(nodeName(project, slave_));
  if (slave_ < 0) {
    subtitle_->setText(tr("%n slave(s), cycle %1", nullptr, static_cast<int>(project.slaves.size()))
                           .arg(cycleText(project.master.cycle_time)));
  } else {
    const auto& slave = project.slaves[static_cast<std::size_t>(slave_)];
    const auto device = QString::fromStdString(slave.device.name.empty() ? slave.device.type : slave.device.name);
    // By these it is told from others; what it is its name says, too.
    const auto place = tr("position %1, address %2").arg(slave_).arg(slave.station_address);
    subtitle_->setText(joinedParts({device, place}), place);
  }
  for (auto* page : pages_) {
    if (page->appliesTo(slave_)) page->refresh();
  }
  showNotes();
}

void DeviceEditor::showLive() {
  const auto& snapshot = workspace_.live().snapshot();
  auto state = snapshot.state;
  bool failed = false;
  bool runs = snapshot.online;
  if (slave_ >= 0) {
    const auto running = runningSlave(workspace_, slave_);
    runs = running.has_value() && running->status != nullptr;
    state = runs ? running->state() : AlState::kNone;
    failed = runs && running->present() && (running->status->al_status & kAlErrorFlag) != 0;
  }
  if (runs) {
    state_->setState(failed ? theme::Tone::kBad : theme::stateTone(state),
                     slave_ < 0 ? masterStateName(state) : stateName(state));
  } else {
    state_->setState(theme::Tone::kNeutral, tr("Offline"));
  }
  state_bar_->showLive();
  if (auto* page = static_cast<Page*>(tabs_->currentWidget())) page->showLive(snapshot);
}

}  // namespace syncline::ui
