// SPDX-License-Identifier: Apache-2.0
#include "ui/text/glossary.h"

#include <QCoreApplication>
#include <string_view>

namespace syncline::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Glossary", text); }

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

}  // namespace

QString masterWord() { return QCoreApplication::translate("Glossary", "Master"); }
QString slaveWord() { return QCoreApplication::translate("Glossary", "Slave"); }

QString stateName(AlState state) {
  return state == AlState::kNone ? QCoreApplication::translate("Glossary", "No response") : fromView(al_state_name(state));
}

QString stateLetter(AlState state) { return state == AlState::kNone ? QStringLiteral("\u2013") : fromView(al_state_letter(state)); }

QString syncStateText(SyncState state) {
  switch (state) {
    case SyncState::kNotMonitored:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Not monitored"));
    case SyncState::kNotReady:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Not ready"));
    case SyncState::kBusy:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Settling"));
    case SyncState::kInSync:
      return tr(QT_TRANSLATE_NOOP("Glossary", "In sync"));
    case SyncState::kOutOfSync:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Out of sync"));
  }
  return {};
}

QString dcmModeText(DcmMode mode) {
  switch (mode) {
    case DcmMode::kOff:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Off"));
    case DcmMode::kBusShift:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Bus shift"));
    case DcmMode::kMasterShift:
      return tr(QT_TRANSLATE_NOOP("Glossary", "Master shift"));
  }
  return {};
}

QString nodeName(const Project& project, int slave) {
  if (slave < 0) return QString::fromStdString(project.master.name);
  if (static_cast<std::size_t>(slave) >= project.slaves.size()) return slaveWord() + u' ' + QString::number(slave);
  return QString::fromStdString(project.slaves[static_cast<std::size_t>(slave)].name);
}

}  // namespace syncline::ui
