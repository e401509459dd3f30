// SPDX-License-Identifier: Apache-2.0
#include "ui/actions.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QUndoGroup>

#include "protocol/al_state.h"
#include "ui/text/glossary.h"
#include "ui/text/menu_key.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

/// "Undo Change: Alias"
QString stepText(const QString& action, const QString& step) {
  return step.isEmpty() ? action : QStringLiteral("%1 %2").arg(action, step);
}

}  // namespace

QAction* Actions::add(const char* name, const QString& text, const char* icon, const QString& tool_tip,
                      const QKeySequence& keys) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setIconText(withoutMenuKey(text));
  action->setShortcut(keys);
  action->setToolTip(keys.isEmpty() ? tool_tip
                                    : QStringLiteral("%1 (%2)").arg(tool_tip, keys.toString(QKeySequence::NativeText)));
  action->setProperty("iconName", QLatin1String(icon));
  if (*icon != '\0') with_icon_.append(action);
  return action;
}

Actions::Actions(QUndoGroup& stacks, QObject* parent) : QObject(parent) {
  create = add("actionNew", tr("&New"), "new", tr("New project"), QKeySequence::New);
  new_machine = add("actionNewMachine", tr("Ne&w Machine…"), "machine",
                    tr("Make a machine step by step: slaves, cycle, clocks, operation modes"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N));
  open = add("actionOpen", tr("&Open…"), "open",
             tr("Open a project, an ENI, an ESI file, a recording, a capture or a scenario"), QKeySequence::Open);
  save = add("actionSave", tr("&Save"), "save", tr("Save the project"), QKeySequence::Save);
  save_as = add("actionSaveAs", tr("Save &As…"), "save-as", tr("Save the project under another name"),
                QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  save_template =
      add("actionSaveTemplate", tr("Save as &Template…"), "", tr("Keep the project as what others can begin with"));
  export_eni = add("actionExport", tr("&Export ENI…"), "export", tr("Write the network information file (ETG.2100)"),
                   QKeySequence(Qt::CTRL | Qt::Key_E));
  export_report = add("actionExportReport", tr("Export with Re&port"), "",
                      tr("Write an HTML report of the machine beside each ENI that is exported"));
  export_report->setCheckable(true);
  close_recording = add("actionCloseRecording", tr("&Close Recording"), "",
                        tr("Show the project and its machine again in place of the recording"));
  overlay = add("actionOverlay", tr("O&verlay Another Recording…"), "",
                tr("Lay the curves of another recording over those of the one that is shown"));
  import_capture = add("actionImportCapture", tr("Import Capture as Recordin&g…"), "",
                       tr("Make a recording of a capture of frames (pcap, pcapng) of any master, and show it"));
  quit = add("actionQuit", tr("&Quit"), "", tr("Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q));
  undo = add("actionUndo", tr("&Undo"), "undo", tr("Take the last edit back"), QKeySequence::Undo);
  redo = add("actionRedo", tr("&Redo"), "redo", tr("Do again what was taken back"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
  go_to = add("actionGoTo", tr("&Go To…"), "", tr("Find a slave, a setting or a command"),
              QKeySequence(Qt::CTRL | Qt::Key_K));
  compare = add("actionCompare", tr("Co&mpare…"), "",
                tr("Compare the project with a file, the running machine or a bus, or two files"),
                QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D));
  undo->setEnabled(stacks.canUndo());
  redo->setEnabled(stacks.canRedo());
  connect(&stacks, &QUndoGroup::canUndoChanged, undo, &QAction::setEnabled);
  connect(&stacks, &QUndoGroup::canRedoChanged, redo, &QAction::setEnabled);
  connect(&stacks, &QUndoGroup::undoTextChanged, undo,
          [this](const QString& step) { undo->setText(stepText(tr("&Undo"), step)); });
  connect(&stacks, &QUndoGroup::redoTextChanged, redo,
          [this](const QString& step) { redo->setText(stepText(tr("&Redo"), step)); });
  demo = add("actionDemo", tr("&Demonstration Machine"), "demo",
             tr("Scan the simulated demonstration machine and go online"));
  scan = add("actionScan", tr("&Scan…"), "scan", tr("Scan a bus and make a project of it"), QKeySequence(Qt::Key_F6));
  choose_link = add("actionChooseLink", tr("Choose the B&us…"), "",
                    tr("On which bus the machine runs: a network card, a scenario, or itself, simulated"));
  online =
      add("actionOnline", tr("Go &Online"), "online", tr("Run the configuration on the bus"), QKeySequence(Qt::Key_F5));
  offline = add("actionOffline", tr("Go O&ffline"), "offline", tr("Bring the bus to INIT and stop"),
                QKeySequence(Qt::SHIFT | Qt::Key_F5));
  record = add("actionRecord", tr("&Record…"), "record", tr("Record the running machine to a file, from now on"),
               QKeySequence(Qt::CTRL | Qt::Key_R));
  record->setCheckable(true);
  save_recent = add("actionSaveRecent", tr("Save the &Last…"), "",
                    tr("Save the last stretch, which is still in memory, as a recording"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
  memory = add("actionMemory", tr("Memor&y for the Last…"), "",
               tr("How many of the latest cycles stay in memory, to be saved afterwards"));
  black_box = add("actionBlackBox", tr("&Black Box of Frames…"), "",
                  tr("Keep the last frames of every run on disk, whole also after a crash"));
  commissioning = add("actionCommissioning", tr("Comm&issioning Report…"), "",
                      tr("Judge the run that is shown by criteria, and write the page to hand over"));
  clear_statistics = add("actionClearStatistics", tr("&Clear Statistics"), "clear", tr("Start counting anew"));
  for (const auto state : {AlState::kInit, AlState::kPreop, AlState::kSafeop, AlState::kOp}) {
    const auto name = stateName(state);
    auto* action = add("", name, "", tr("Request %1 for all slaves (register 0x0120)").arg(name));
    action->setObjectName(QStringLiteral("actionRequest") + name);
    action->setData(static_cast<int>(state));
    states.append(action);
  }
  auto* group = new QActionGroup(this);
  const struct {
    theme::Mode mode;
    QString text;
  } modes[] = {{theme::Mode::kSystem, tr("&System Colours")},
               {theme::Mode::kLight, tr("&Light")},
               {theme::Mode::kDark, tr("&Dark")},
               {theme::Mode::kContrast, tr("High &Contrast")}};
  for (const auto& mode : modes) {
    auto* action = add("", mode.text, "", mode.text);
    action->setObjectName(QStringLiteral("actionTheme_") + theme::modeName(mode.mode));
    action->setCheckable(true);
    action->setData(static_cast<int>(mode.mode));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [mode = mode.mode] { theme::apply(mode); });
    themes.append(action);
  }
  toggle_theme = add("actionToggleTheme", tr("Light/Dark"), "theme", tr("Switch between light and dark"));
  reset_layout = add("actionResetLayout", tr("&Reset Layout"), "", tr("Put all panels back in their places"));
  overview = add("actionOverview", tr("&Overview"), "overview",
                 tr("Whether the machine is in sync, since when, and what happened first"), QKeySequence(Qt::Key_F7));
  overview->setCheckable(true);
  expert = add("actionExpert", tr("&Expert Settings"), "", tr("Show the settings that few machines need"),
               QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_X));
  expert->setCheckable(true);
  about = add("actionAbout", tr("&About Syncline"), "", tr("Version, licence and trademarks"));
}

void Actions::drawIcons(const QPalette& palette) {
  for (auto* action : with_icon_) {
    QColor color;
    if (action == online) color = theme::toneColor(palette, theme::Tone::kGood);
    if (action == offline) color = theme::toneColor(palette, theme::Tone::kBad);
    action->setIcon(theme::icon(action->property("iconName").toString(), palette, color));
  }
  for (auto* action : themes) action->setChecked(static_cast<theme::Mode>(action->data().toInt()) == theme::current());
}

}  // namespace syncline::ui
