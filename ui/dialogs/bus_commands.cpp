// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/bus_commands.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reasons/because.h"
#include "settings/settings_table.h"
#include "ui/dialogs/cut_short_dialog.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/found_dialog.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/link_text.h"

namespace syncline::ui {
namespace {

/// Whether another bus is the way on: this one cannot be had, or nobody is there.
bool isOfTheLink(ErrorCode code) {
  constexpr ErrorCode kOfTheLink[] = {ErrorCode::kLinkNotFound, ErrorCode::kLinkDown,     ErrorCode::kLinkPermission,
                                      ErrorCode::kLinkIo,       ErrorCode::kFileNotFound, ErrorCode::kFileNotReadable,
                                      ErrorCode::kNoResponse};
  return std::ranges::find(kOfTheLink, code) != std::end(kOfTheLink);
}

}  // namespace

BusCommands::BusCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window) {
  connect(&workspace.scan(), &ScanController::finished, this, &BusCommands::onFound);
  connect(&workspace.scan(), &ScanController::failed, this, [this](const QString& link, const Error& error) {
    demo_ = false;
    if (error.code != ErrorCode::kCancelled) tellOfScan(link, error);
  });
}

void BusCommands::scan() {
  auto* chooser = new LinkChooser(workspace_.environment(), workspace_.usualLink(), tr("Scan"), &window_);
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  connect(chooser, &QDialog::accepted, this, [this, chooser] { scanLink(chooser->link()); });
  chooser->open();
}

void BusCommands::scanLink(const QString& link) {
  if (link.isEmpty()) return;
  if (const auto free = workspace_.mayUse(link); !free) {
    demo_ = false;
    return tellOfScan(link, free.error());
  }
  if (!mayGoOffline(window_, workspace_, tr("A scan needs the bus for itself."))) {
    demo_ = false;
    return;
  }
  workspace_.live().shutDown();
  workspace_.recording().close();
  workspace_.scan().start(link);
}

void BusCommands::onFound(const QString& link, const ScanOutcome& outcome) {
  auto& document = workspace_.document();
  if (!std::exchange(demo_, false)) {
    if (!document.project().slaves.empty() || outcome.looked_only) return showFound(link, outcome);
    return document.replace(tr("Scan"), outcome.built.project);
  }
  document.replace(tr("Scan"), outcome.built.project);
  const SettingEdit monitor{&settings::row("master.dc.sync_window"), {}, true};
  static_cast<void>(document.set(tr("Monitor the sync window"), {monitor}));
  goOnline();
}

void BusCommands::showFound(const QString& link, const ScanOutcome& outcome) {
  auto* dialog = new FoundDialog(workspace_.document().project(), outcome,
                                 linkName(link, workspace_.environment().demo_link), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &FoundDialog::wanted, this, [this](const Project& project, const QStringList& lost) {
    workspace_.document().replace(tr("Scan"), project);
    for (const auto& key : lost) {
      workspace_.report(
          Error{ErrorCode::kUnknownKey, key.toStdString(), because("the other revision does not take it")},
          Severity::kWarning, tr("Scan"));
    }
  });
  connect(dialog, &FoundDialog::touchWanted, this,
          [this, link] { workspace_.scan().start(link, ScanController::Depth::kTouch); });
  dialog->open();
}

void BusCommands::goOnline() {
  if (!workspace_.link().isEmpty()) return start();
  chooseLink(tr("Go Online"), [this] { start(); });
}

void BusCommands::chooseLink() {
  chooseLink(tr("Choose"), [] {});
}

void BusCommands::chooseLink(const QString& action, const std::function<void()>& then) {
  auto* chooser = new LinkChooser(workspace_.environment(), workspace_.usualLink(), action, &window_);
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  const auto& slaves = workspace_.document().project().slaves;
  if (!slaves.empty()) chooser->offerMachine(static_cast<int>(slaves.size()));
  connect(chooser, &QDialog::accepted, this, [this, chooser, then] {
    workspace_.setLink(chooser->link());
    then();
  });
  chooser->open();
}

void BusCommands::start() {
  restarted_ = false;
  if (auto status = workspace_.goOnline(); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Master"));
    tell(tr("The master could not go online."), workspace_.link(), status.error(),
         [this] { chooseLink(tr("Go Online"), [this] { start(); }); });
  }
}

void BusCommands::tellOfScan(const QString& link, const Error& error) {
  tell(tr("The bus could not be scanned."), link, error, [this] { scan(); });
}

void BusCommands::tell(const QString& what, const QString& link, const Error& error,
                       const std::function<void()>& other_bus) {
  const bool of_the_link = isOfTheLink(error.code) || !workspace_.mayUse(link);
  if (!of_the_link) return showError(&window_, what, error);
  showError(&window_, what, error, tr("Choose Another &Bus…"), other_bus);
}

void BusCommands::restart() {
  if (!ask(window_, "restartQuestion", tr("Restart the machine with the project as it is now?"),
           tr("All slaves go to INIT and come up again."), tr("Restart"))) {
    return;
  }
  workspace_.live().shutDown();
  start();
  restarted_ = true;
}

void BusCommands::goOffline() {
  if (mayStopWriting(window_, workspace_)) workspace_.live().goOffline();
}

void BusCommands::offerRepairs() {
  auto* dialog = new CutShortDialog(workspace_.eepromRepair(), &window_);
  connect(dialog, &CutShortDialog::told, this, [this](const QString& text) { workspace_.inform(tr("EEPROM"), text); });
  connect(dialog, &QDialog::finished, dialog, &QObject::deleteLater);
  dialog->offer();
  if (!dialog->isVisible()) dialog->deleteLater();
}

void BusCommands::startDemo() { startDemo(workspace_.environment().demo_link); }

void BusCommands::startDemo(const QString& link) {
  demo_ = true;
  scanLink(link);
}

}  // namespace syncline::ui
