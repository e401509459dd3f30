// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/questions.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

/// What ends when all slaves go to INIT, in words.
QString atTheEnd(Workspace& workspace) {
  auto text = QCoreApplication::translate("Questions", "All slaves go to INIT.");
  if (workspace.requests().writing()) {
    text.prepend(QCoreApplication::translate("Questions", "A slave is being written to, which ends unfinished.") +
                 u' ');
  }
  return text;
}

}  // namespace

bool mayStopWriting(QWidget& window, Workspace& workspace) {
  if (!workspace.requests().writing()) return true;
  return ask(window, "writingQuestion",
             QCoreApplication::translate("Questions", "A slave is being written to. Go offline all the same?"),
             QCoreApplication::translate("Questions",
                                         "An EEPROM gets back what it held; a slave that has half of a file may not "
                                         "come up any more."),
             QCoreApplication::translate("Questions", "Go Offline"));
}

bool ask(QWidget& window, const char* object_name, const QString& text, const QString& more, const QString& on) {
  QMessageBox box(QMessageBox::Question, QStringLiteral("Syncline"), text, QMessageBox::Cancel, &window);
  box.setObjectName(QLatin1String(object_name));
  box.setInformativeText(more);
  auto* go = box.addButton(on, QMessageBox::AcceptRole);
  go->setObjectName(QStringLiteral("questionGo"));
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == go;
}

bool mayEndAll(QWidget& window, Workspace& workspace, const QString& why) {
  QStringList running;
  const auto names = workspace.document().networks();
  for (int i = 0; i < names.size(); ++i) {
    if (workspace.runs().of(i).run.phase() != NetworkRun::Phase::kOffline) running << names[i];
  }
  if (running.isEmpty()) return true;
  if (names.size() == 1) return mayGoOffline(window, workspace, why);
  return ask(window, "offlineQuestion",
             QCoreApplication::translate("Questions", "Take %1 offline?").arg(QLocale().createSeparatedList(running)),
             why + QLatin1Char(' ') + atTheEnd(workspace), QCoreApplication::translate("Questions", "Go Offline"));
}

void tellGivenUp(QWidget& window) {
  QMessageBox box(QMessageBox::Warning, QStringLiteral("Syncline"),
                  QCoreApplication::translate("Questions", "The slaves may still be in OP."), QMessageBox::Close,
                  &window);
  box.setObjectName(QStringLiteral("givenUpWarning"));
  box.setInformativeText(
      QCoreApplication::translate("Questions",
                                  "The master did not go offline in time: it ends with the program, and nobody has "
                                  "taken the slaves to INIT. Make the machine safe by other means."));
  box.exec();
}

bool mayGoOffline(QWidget& window, Workspace& workspace, const QString& why) {
  if (workspace.live().phase() == LiveSession::Phase::kOffline) return true;
  return ask(window, "offlineQuestion",
             QCoreApplication::translate("Questions", "The machine is running. Take it offline?"),
             why + QLatin1Char(' ') + atTheEnd(workspace), QCoreApplication::translate("Questions", "Go Offline"));
}

}  // namespace syncline::ui
