// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window.h"

#include <QCloseEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "record/run_record.h"
#include "ui/action_states.h"
#include "ui/actions.h"
#include "ui/column_memory.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/compare_dialog.h"
#include "ui/dialogs/export_menu.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/finding_fixes.h"
#include "ui/dialogs/language_menu.h"
#include "ui/dialogs/network_commands.h"
#include "ui/dialogs/questions.h"
#include "ui/dialogs/recent_menu.h"
#include "ui/dialogs/recording_commands.h"
#include "ui/dialogs/scan_progress.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/dialogs/slave_state_commands.h"
#include "ui/dialogs/template_commands.h"
#include "ui/machine_building.h"
#include "ui/pages/device_editor.h"
#include "ui/pages/welcome_page.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/findings_panel.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/messages_panel.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/run_bar.h"
#include "ui/panels/slave_counts_memory.h"
#include "ui/panels/start_bar.h"
#include "ui/panels/status_panel.h"
#include "ui/session/project_limits.h"
#include "ui/session/recorded_views.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/glossary.h"
#include "ui/theme/theme.h"
#include "ui/widgets/calm_wheel.h"
#include "ui/widgets/kept_focus.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/whole_texts.h"
#include "ui/window_centre.h"
#include "ui/window_dialogs.h"
#include "ui/window_docks.h"
#include "ui/window_layout.h"
#include "ui/window_menus.h"
#include "ui/window_overlay.h"
#include "ui/window_replay.h"
#include "ui/window_trigger.h"

namespace syncline::ui {
MainWindow::MainWindow(Workspace& workspace, QWidget* parent) : QMainWindow(parent), workspace_(workspace) {
  installSpokenValues();
  new CalmWheel(this);
  new KeptFocus(this);
  new WholeTexts(this);
  setObjectName(QStringLiteral("mainWindow"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/syncline.svg")));
  setAcceptDrops(true);
  setDockNestingEnabled(false);
  actions_ = new Actions(workspace.document().undoGroup(), this);
  files_ = new FileCommands(workspace, *this);
  networks_ = new NetworkCommands(workspace, *this, [this] { return commitFields(); });
  templates_ = new TemplateCommands(workspace, *files_, *this);
  dialogs_ = new WindowDialogs(workspace, *files_, *this);
  bus_ = new BusCommands(workspace, *this);
  recordings_ = new RecordingCommands(workspace, *this);
  building_ = new MachineBuilding(workspace, *this, [this] { return commitFields(); });
  new ScanProgress(workspace.scan(), this);
  buildCentre();
  docks_ = new WindowDocks(workspace, *this, *building_->dock());
  connectDocks();
  layout_ = std::make_unique<WindowLayout>(*this, workspace.memory(), docks_->parts(*centre_));
  buildMenus();
  new StatusPanel(workspace, *statusBar());
  connectActions();
  connectSession();
  new WindowTrigger(workspace.trigger(), docks_->trigger(), *strip_, *recordings_, this);
  overlay_ = new WindowOverlay(workspace, *strip_, centre_->overlayBar(), *this);
  connect(overlay_, &WindowOverlay::refused, this,
          [this](const QString& why) { statusBar()->showMessage(why, 10'000); });
  connect(actions_->overlay, &QAction::triggered, overlay_, &WindowOverlay::ask);
  new WindowReplay(workspace, *strip_, *overview_, *findings_, this);
  resize(1280, 800);
  updateTheme();
  updateTitle();
  updateActions();
  takeUp();
}

/// A field that loses the focus hands in what was typed: now, while there is a window that hears of it.
MainWindow::~MainWindow() {
  if (auto* field = focusWidget()) field->clearFocus();
}

void MainWindow::buildCentre() {
  auto* welcome = new WelcomePage(
      {actions_->demo, actions_->new_machine, actions_->scan, building_->commands().add, actions_->open},
      workspace_.memory(), workspace_.templates());
  connect(welcome, &WelcomePage::templateWanted, templates_, &TemplateCommands::begin);
  connect(welcome, &WelcomePage::templateRemoveWanted, templates_, &TemplateCommands::remove);
  connect(welcome, &WelcomePage::fileWanted, this, [this](const QString& file) { files_->openAny(file); });
  centre_ = new WindowCentre(workspace_, welcome);
  editor_ = &centre_->editor();
  overview_ = &centre_->overview();
  strip_ = &centre_->strip();
  connect(overview_, &OverviewPanel::momentWanted, this, &MainWindow::goToMoment);
  connect(overview_, &OverviewPanel::armWanted, &workspace_.live(), &LiveSession::arm);
  connect(strip_, &LiveStrip::eventClicked, this, &MainWindow::selectMoment);
  rememberSlaveCounts(*strip_, workspace_.memory());
  connect(strip_, &LiveStrip::noteWanted, this, [this](qint64 time) { recordings_->writeNote(time); });
  connect(strip_, &LiveStrip::variablesWanted, this, [this] {
    selectNode(-1);
    editor_->showPage("variablesPage");
  });
  connect(strip_, &LiveStrip::limitWanted, this, [this](Signal signal, double magnitude) {
    if (workspace_.recording().isOpen()) return;
    if (const auto status = setLimit(workspace_.document(), signal, magnitude); !status)
      statusBar()->showMessage(errorText(status.error()), 10'000);
  });
  connect(strip_, &LiveStrip::viewsEdited, &workspace_.document(), &ProjectDocument::setViews);
  connect(strip_, &LiveStrip::triggerWanted, this, [this] { docks_->showTrigger(); });
  auto* bar = &centre_->runBar();
  connect(bar, &RunBar::differencesWanted, this,
          [this] { dialogs_->compare({ComparedSide::Kind::kRunning}, {ComparedSide::Kind::kProject}); });
  connect(bar, &RunBar::restartWanted, this, [this] {
    if (commitFields()) bus_->restart();
  });
  connect(bar, &RunBar::revertWanted, this, [this] {
    editor_->revertFields();
    workspace_.document().replace(tr("Revert to what runs"), workspace_.runDifference().running());
  });
  auto* start_bar = &centre_->startBar();
  connect(start_bar, &StartBar::scanWanted, this, [this] {
    if (commitFields()) bus_->scanLink(workspace_.link());
  });
  connect(start_bar, &StartBar::slaveWanted, this, [this](int position) {
    // Of a run that has ended; the project may have been edited since.
    const auto& slaves = workspace_.live().record()->config().slaves;
    const auto address = slaves[static_cast<std::size_t>(position)].station_address;
    const auto& project = workspace_.document().project().slaves;
    const auto found = std::ranges::find(project, address, &SlaveSettings::station_address);
    if (found != project.end()) goTo(static_cast<int>(found - project.begin()), {});
  });
  setCentralWidget(centre_);
}

void MainWindow::connectDocks() {
  explorer_ = &docks_->explorer();
  messages_ = &docks_->messages();
  findings_ = &docks_->findings();
  building_->tieTo(*explorer_);
  auto* messages = messages_;
  connect(messages, &MessagesPanel::activated, this, &MainWindow::goToMessage);
  auto* findings = findings_;
  connect(findings, &FindingsPanel::momentActivated, strip_, &LiveStrip::goTo);
  connect(strip_, &LiveStrip::slaveWanted, this, [this](int position) {
    const int slave = workspace_.recording().isOpen() ? position : workspace_.runningSlaves().slaveOf(position);
    if (slave >= 0 || position < 0) goTo(slave, {});
  });
  connect(explorer_, &ExplorerPanel::nodeSelected, editor_, &DeviceEditor::showNode);
  connect(explorer_, &ExplorerPanel::nodeSelected, this, [this](int slave) {
    if (workspace_.recording().isOpen()) return;
    strip_->setPickedSlave(workspace_.runningSlaves().positionOf(slave));
    showOverview(false);
  });
  connect(explorer_, &ExplorerPanel::nodeClicked, this, [this] { showOverview(false); });
  connect(explorer_, &ExplorerPanel::countersWanted, this, [this](int slave) {
    selectNode(slave);
    editor_->showPage("slaveCountersPage");
  });
  connect(dialogs_, &WindowDialogs::placeWanted, this, &MainWindow::goTo);
  connect(dialogs_, &WindowDialogs::nodeWanted, explorer_, &ExplorerPanel::select);
  connect(dialogs_, &WindowDialogs::keyWanted, this, [this](const QString& key) { goTo(explorer_->selected(), key); });
  connect(dialogs_, &WindowDialogs::objectWanted, this, [this](int slave, coe::ObjectAddress object) {
    goTo(slave, {});
    editor_->showObject(object);
  });
  auto* fixes = new FindingFixes(
      workspace_, [this] { return commitFields(); }, this);
  connect(messages, &MessagesPanel::menuOpens, fixes, &FindingFixes::fill);
  connect(findings, &FindingsPanel::menuOpens, fixes, &FindingFixes::fillFor);
  connect(findings, &FindingsPanel::findingActivated, fixes, &FindingFixes::go);
  connect(editor_, &DeviceEditor::findingMenuOpens, fixes, &FindingFixes::fill);
  connect(fixes, &FindingFixes::placeWanted, this, &MainWindow::goTo);
  connect(editor_, &DeviceEditor::nodeWanted, explorer_, &ExplorerPanel::select);
  connect(explorer_, &ExplorerPanel::networkWanted, networks_, &NetworkCommands::choose);
  connect(networks_, &NetworkCommands::refused, this,
          [this](const QString& why) { statusBar()->showMessage(why, 10'000); });
  connect(explorer_, &ExplorerPanel::menuOpens, this, [this](QMenu& menu, int slave) {
    menu.addSeparator();
    editor_->states().addTo(menu, slave);
  });
}

void MainWindow::buildMenus() {
  auto* recent = new RecentMenu(workspace_.memory(), workspace_.document(), this);
  connect(recent, &RecentMenu::fileWanted, this, [this](const QString& path) {
    if (commitFields()) files_->openAny(path);
  });
  auto* language = new LanguageMenu(
      workspace_.memory(), [this] { return commitFields(); }, this);
  connect(language, &LanguageMenu::chosen, this, &MainWindow::languageChosen);
  auto* exports = new ExportMenu(workspace_, *files_, *this, [this] { return commitFields(); });
  auto* network =
      ui::buildMenus(*menuBar(), *actions_,
                     {recent, language, exports, building_->commands().all(), networks_->all(), docks_->toggles(),
                      explorer_->viewActions(), editor_->modeActions(), centre_->replayBar().commands()});
  connect(network, &QMenu::aboutToShow, this, &MainWindow::updateRecordingActions);
  state_button_ = buildToolBar(*addToolBar(tr("Main")), *actions_);
}

void MainWindow::connectActions() {
  const auto on = [this](QAction* action, auto command) {
    connect(action, &QAction::triggered, this, [this, command] {
      if (commitFields()) command();
    });
  };
  on(actions_->create, [this] { files_->create(); });
  on(actions_->new_machine, [this] { dialogs_->makeNewMachine(); });
  on(actions_->open, [this] { files_->open(); });
  on(actions_->save, [this] { files_->save(); });
  on(actions_->save_as, [this] { files_->saveAs(); });
  on(actions_->save_template, [this] { templates_->save(); });
  on(actions_->export_eni, [this] { files_->exportEni(); });
  auto& eni = workspace_.eni();
  actions_->export_report->setChecked(eni.reported());
  connect(actions_->export_report, &QAction::toggled, &eni, &EniPreview::setReported);
  connect(&eni, &EniPreview::reportedChanged, actions_->export_report,
          [this] { actions_->export_report->setChecked(workspace_.eni().reported()); });
  connect(editor_, &DeviceEditor::compareWanted, actions_->compare, &QAction::trigger);
  connect(editor_, &DeviceEditor::exportWanted, actions_->export_eni, &QAction::trigger);
  on(actions_->scan, [this] { bus_->scan(); });
  on(actions_->demo, [this] {
    if (files_->mayDiscard()) bus_->startDemo();
  });
  on(actions_->choose_link, [this] { bus_->chooseLink(); });
  on(actions_->online, [this] { bus_->goOnline(); });
  auto& stack = workspace_.document().undoGroup();
  connect(actions_->undo, &QAction::triggered, this, [this, &stack] {
    // What was typed last is what is taken back first, also where it is no value.
    if (editor_->commitFields()) return stack.undo();
    editor_->revertFields();
  });
  on(actions_->redo, [&stack] { stack.redo(); });
  on(actions_->compare, [this] { dialogs_->compare({}, CompareDialog::usualSide(workspace_)); });
  on(actions_->go_to, [this] { dialogs_->search(explorer_->selected()); });
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->offline, &QAction::triggered, bus_, &BusCommands::goOffline);
  connect(actions_->clear_statistics, &QAction::triggered, &workspace_.live(), &LiveSession::clearStatistics);
  connect(actions_->overview, &QAction::triggered, this, &MainWindow::showOverview);
  connect(actions_->close_recording, &QAction::triggered, &workspace_.recording(), &OpenedRecording::close);
  connect(actions_->record, &QAction::triggered, this, [this] {
    recordings_->toggle();
    updateRecordingActions();
  });
  connect(actions_->save_recent, &QAction::triggered, recordings_, &RecordingCommands::saveLast);
  connect(actions_->import_capture, &QAction::triggered, recordings_, qOverload<>(&RecordingCommands::importCapture));
  connect(actions_->memory, &QAction::triggered, recordings_, &RecordingCommands::askMemory);
  connect(actions_->black_box, &QAction::triggered, recordings_, &RecordingCommands::askBlackBox);
  connect(actions_->commissioning, &QAction::triggered, recordings_, &RecordingCommands::askCommissioning);
  for (auto* action : actions_->states) {
    connect(action, &QAction::triggered, this,
            [this, action] { workspace_.live().requestState(static_cast<AlState>(action->data().toInt())); });
  }
  connect(actions_->toggle_theme, &QAction::triggered, this,
          [this] { theme::apply(theme::isDark(palette()) ? theme::Mode::kLight : theme::Mode::kDark); });
  connect(actions_->expert, &QAction::triggered, this, [this](bool expert) {
    if (commitFields()) workspace_.setExpert(expert);
    actions_->expert->setChecked(workspace_.expert());
  });
  connect(&workspace_, &Workspace::expertChanged, actions_->expert,
          [this] { actions_->expert->setChecked(workspace_.expert()); });
  actions_->expert->setChecked(workspace_.expert());
  connect(actions_->reset_layout, &QAction::triggered, this, [this] {
    layout_->reset();
    columns_->reset();
  });
  connect(actions_->about, &QAction::triggered, this, [this] {
    auto* dialog = new AboutDialog(workspace_.environment().version, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
  });
}

/// Commands work on what the fields show.
bool MainWindow::commitFields() {
  const bool taken = editor_->commitFields();
  if (!taken)
    statusBar()->showMessage(tr("A field holds what cannot be a value: mend it, or press Esc in it."), 10'000);
  return taken;
}

void MainWindow::connectSession() {
  auto& document = workspace_.document();
  connect(&document, &ProjectDocument::modifiedChanged, this, &MainWindow::updateTitle);
  connect(&document, &ProjectDocument::pathChanged, this, [this] {
    updateTitle();
    if (const auto& path = workspace_.document().path(); !path.isEmpty()) workspace_.memory().remember(path);
  });
  connect(files_, &FileCommands::linkWanted, bus_, &BusCommands::scanLink);
  connect(files_, &FileCommands::comparisonWanted, this, [this](const QString& path) {
    dialogs_->compare({}, {ComparedSide::Kind::kFile, path});
  });
  connect(files_, &FileCommands::recordingWanted, recordings_, &RecordingCommands::open);
  connect(&document, &ProjectDocument::projectChanged, this, [this](bool structural) {
    updateActions();
    if (structural && workspace_.live().phase() == LiveSession::Phase::kOffline && !workspace_.recording().isOpen()) {
      strip_->setRecord(nullptr);
      centre_->showStrip(false);
      workspace_.trigger().setRecord(nullptr, false);
      overview_->setRecord(nullptr, false);
    }
  });
  const auto show_views = [this] { strip_->setViews(workspace_.document().views()); };
  connect(&document, &ProjectDocument::viewsChanged, strip_, show_views);
  connect(&document, &ProjectDocument::projectChanged, this, &MainWindow::showLimits);
  connect(&document, &ProjectDocument::taken, strip_, show_views);
  auto& live = workspace_.live();
  connect(&live, &LiveSession::phaseChanged, this, &MainWindow::updateActions);
  connect(&live, &LiveSession::phaseChanged, this, &MainWindow::showWhetherItGoesOn);
  connect(&workspace_.runs(), &NetworkRuns::phaseChanged, this, [this](int network) {
    const bool online = workspace_.live().phase() == LiveSession::Phase::kOnline;
    if (network == workspace_.document().network() && online && !bus_->restarted()) showOverview(true);
  });
  connect(&live, &LiveSession::recordChanged, this, &MainWindow::showRun);
  connect(&workspace_.runs(), &NetworkRuns::findingsChanged, overview_,
          [this] { overview_->setFindings(workspace_.shownFindings()); });
  connect(&workspace_.recording(), &OpenedRecording::changed, this, [this] {
    showRun();
    updateActions();
    updateTitle();
  });
  connect(&workspace_.runs(), &NetworkRuns::diskChanged, this, &MainWindow::updateRecordingActions);
  connect(&workspace_.scan(), &ScanController::started, this, &MainWindow::updateActions);
  connect(&workspace_.scan(), &ScanController::finished, this, &MainWindow::updateActions);
  connect(&workspace_.scan(), &ScanController::failed, this, &MainWindow::updateActions);
}

void MainWindow::showWhetherItGoesOn() {
  const auto phase = workspace_.live().phase();
  const bool goes_on = phase == LiveSession::Phase::kOnline || phase == LiveSession::Phase::kStarting;
  overview_->setLive(goes_on);
  strip_->timeView()->setGoesOn(goes_on);
  // A start that failed has nothing to plot.
  if (phase == LiveSession::Phase::kOffline && !workspace_.recording().isOpen()) {
    const auto* record = workspace_.live().record();
    if (record == nullptr || record->samples().empty()) {
      strip_->setRecord(nullptr);
      centre_->showStrip(false);
    }
  }
}

MainWindow::Place MainWindow::place() const {
  const auto* page = editor_->tabs()->currentWidget();
  return {explorer_->selected(), page == nullptr ? QString() : page->objectName(), centre_->showsOverview()};
}

void MainWindow::goToPlace(const Place& place) {
  explorer_->select(place.node);
  editor_->showPage(place.page.toLatin1().constData());
  showOverview(place.overview);
}

/// What the workspace has already, when a window comes to it.
void MainWindow::takeUp() {
  strip_->setViews(workspace_.document().views());
  showRecord();
  showWhetherItGoesOn();
  updateRecordingActions();
}

/// Another run, or a recording in its place: an armed trigger looks at it.
void MainWindow::showRun() {
  workspace_.trigger().setRecord(workspace_.shownRecord(), workspace_.recording().isOpen());
  showRecord();
}

/// Plots and figures of what is shown.
void MainWindow::showRecord() {
  const bool recorded = workspace_.recording().isOpen();
  strip_->setPickedSlave(recorded ? -1 : workspace_.runningSlaves().positionOf(explorer_->selected()));
  strip_->setOfferedViews(recorded ? recordedViews(workspace_.recording().run().info.about)
                                   : std::vector<MonitorView>{});
  strip_->setRecord(workspace_.shownRecord(), recorded);
  centre_->showStrip(workspace_.shownRecord() != nullptr);
  showLimits();
  overview_->setRecord(workspace_.shownRecord(), recorded);
  overview_->setFindings(workspace_.shownFindings());
  if (recorded) showOverview(true);
}

/// Those of the project can be changed where its run is seen; a recording is of another time.
void MainWindow::showLimits() {
  strip_->setWantedLimits(workspace_.recording().isOpen() ? std::nullopt
                                                          : std::optional(limitsOf(workspace_.document().project())));
}

/// The page of the node that is selected, or whether the machine is in sync; of a recording there are no pages.
void MainWindow::showOverview(bool overview) {
  overview = overview || workspace_.recording().isOpen();
  actions_->overview->setChecked(overview);
  centre_->showOverview(overview);
}

/// An event of the run: in the plots, in the messages, in the findings.
void MainWindow::goToMoment(qint64 moment) {
  strip_->goTo(moment);
  selectMoment(moment);
}

void MainWindow::selectMoment(qint64 moment) {
  messages_->selectMoment(moment);
  findings_->selectMoment(moment);
}

/// An event of a run is where its network is; what was before in that network has no curves any more.
void MainWindow::goToMessage(const Message& message) {
  if (message.run > 0) {
    const int network = workspace_.runs().networkOf(message.run);
    if (network < 0) return;
    if (network != workspace_.document().network()) networks_->choose(network);
    if (network != workspace_.document().network()) return;
  }
  if (message.moment != 0 && (message.run <= 0 || message.run == workspace_.runs().current().number))
    strip_->goTo(message.moment);
  goTo(message.slave, message.key);
}

/// To the field, or where there is none to its slave; a recording has its own slaves, by their positions, and no pages.
void MainWindow::goTo(int slave, const QString& key) {
  if (workspace_.recording().isOpen()) return strip_->setPickedSlave(slave);
  if (key.isEmpty() || !editor_->showKey(key)) explorer_->select(slave);
  showOverview(false);
}

void MainWindow::updateTitle() {
  const auto& document = workspace_.document();
  if (workspace_.recording().isOpen()) {
    setWindowTitle(tr("Recording %1 – Syncline").arg(QFileInfo(workspace_.recording().path()).fileName()));
    return setWindowModified(false);
  }
  setWindowTitle(document.readOnly() ? tr("%1[*] (read-only) – Syncline").arg(document.displayName())
                                     : tr("%1[*] – Syncline").arg(document.displayName()));
  setWindowModified(workspace_.document().isModified());
}

void MainWindow::updateActions() {
  const bool recorded = workspace_.recording().isOpen();
  centre_->showWelcome(!recorded && workspace_.document().project().slaves.empty());
  state_button_->setEnabled(workspace_.live().phase() == LiveSession::Phase::kOnline);
  updateActionStates(*actions_, workspace_, *recordings_);
}

void MainWindow::updateRecordingActions() { updateRecordingStates(*actions_, workspace_, *recordings_); }

void MainWindow::updateTheme() {
  actions_->drawIcons(palette());
  building_->commands().add->setIcon(theme::icon(QStringLiteral("device"), palette()));
  state_button_->setIcon(theme::icon(QStringLiteral("state"), palette()));
  state_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  // The children get the new palette after the window: let it reach the plots first.
  QMetaObject::invokeMethod(strip_, &LiveStrip::applyTheme, Qt::QueuedConnection);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  // Docks take sizes only once the window has its own.
  if (std::exchange(laid_out_, true)) return;
  layout_->reset();
  layout_->recall();
  columns_ = new ColumnMemory(*this, workspace_.memory());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  editor_->commitFields();
  if (!files_->mayDiscard() || !mayEndAll(*this, workspace_, tr("The program ends."))) return event->ignore();
  workspace_.autosave().forget();
  workspace_.scan().cancel();
  workspace_.runs().shutDown();
  if (workspace_.runs().givenUp()) tellGivenUp(*this);
  workspace_.runs().finish();
  event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && state_button_ != nullptr) updateTheme();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto file = event->mimeData()->urls().front().toLocalFile();
  if (commitFields()) files_->openDropped(file);
}

}  // namespace syncline::ui
