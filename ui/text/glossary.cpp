// SPDX-License-Identifier: Apache-2.0
#include "ui/text/glossary.h"

#include "config/network_config.h"
#include "config/project.h"
#include "ui/text/units.h"

#include <QCoreApplication>
#include <string_view>

namespace syncline::ui {

QString masterWord() { return QCoreApplication::translate("Glossary", "Master"); }
QString slaveWord() { return QCoreApplication::translate("Glossary", "Slave"); }

QString stateName(AlState state) {
  return state == AlState::kNone ? QCoreApplication::translate("Glossary", "No response")
                                 : fromView(al_state_name(state));
}

QString masterStateName(AlState state) {
  return state == AlState::kNone ? QCoreApplication::translate("Glossary", "Slaves missing") : stateName(state);
}

QString stateLetter(AlState state) {
  return state == AlState::kNone ? QStringLiteral("\u2013") : fromView(al_state_letter(state));
}

QString syncStateText(SyncState state) {
  switch (state) {
    case SyncState::kNotMonitored:
      return QCoreApplication::translate("Glossary", "Not monitored");
    case SyncState::kNotReady:
      return QCoreApplication::translate("Glossary", "Not ready");
    case SyncState::kBusy:
      return QCoreApplication::translate("Glossary", "Settling");
    case SyncState::kInSync:
      return QCoreApplication::translate("Glossary", "In sync");
    case SyncState::kOutOfSync:
      return QCoreApplication::translate("Glossary", "Out of sync");
    case SyncState::kUnknown:
      return QCoreApplication::translate("Glossary", "Unknown");
  }
  return {};
}

QString obstacleText(dc::SyncObstacle obstacle) {
  switch (obstacle) {
    case dc::SyncObstacle::kNone:
      break;
    case dc::SyncObstacle::kNoReferenceClock:
      return QCoreApplication::translate("Glossary", "no reference clock");
    case dc::SyncObstacle::kNoReading:
      return QCoreApplication::translate("Glossary", "no reading of the reference clock");
    case dc::SyncObstacle::kClockStep:
      return QCoreApplication::translate("Glossary", "the reference clock has stepped");
    case dc::SyncObstacle::kErrorCode:
      return QCoreApplication::translate("Glossary", "error of the controller");
    case dc::SyncObstacle::kControlError:
      return QCoreApplication::translate("Glossary", "schedule beyond its limit");
    case dc::SyncObstacle::kCyclesLeftOut:
      return QCoreApplication::translate("Glossary", "cycles left out");
    case dc::SyncObstacle::kLateFrames:
      return QCoreApplication::translate("Glossary", "frames later than the set value allows");
    case dc::SyncObstacle::kSettling:
      return QCoreApplication::translate("Glossary", "settling");
    case dc::SyncObstacle::kToExternalClock:
      return QCoreApplication::translate("Glossary", "on the way to the external clock");
    case dc::SyncObstacle::kExternalClock:
      return QCoreApplication::translate("Glossary", "away from the external clock");
  }
  return {};
}

QString dcmModeText(DcmMode mode) {
  switch (mode) {
    case DcmMode::kOff:
      return QCoreApplication::translate("Glossary", "Off");
    case DcmMode::kBusShift:
      return QCoreApplication::translate("Glossary", "Bus shift");
    case DcmMode::kMasterShift:
      return QCoreApplication::translate("Glossary", "Master shift");
    case DcmMode::kMasterRefClock:
      return QCoreApplication::translate("Glossary", "Master reference clock");
    case DcmMode::kLinkLayerRefClock:
      return QCoreApplication::translate("Glossary", "Adapter reference clock");
    case DcmMode::kDcx:
      return QCoreApplication::translate("Glossary", "External clock (DCX)");
    case DcmMode::kMasterShiftByApp:
      return QCoreApplication::translate("Glossary", "Master shift by application");
  }
  return {};
}

namespace {

template <class Network>
QString nameIn(const Network& network, int slave) {
  if (slave < 0) return QString::fromStdString(network.master.name);
  if (static_cast<std::size_t>(slave) >= network.slaves.size()) return slaveWord() + u' ' + QString::number(slave);
  return QString::fromStdString(network.slaves[static_cast<std::size_t>(slave)].name);
}

}  // namespace

QString nodeName(const Project& project, int slave) { return nameIn(project, slave); }
QString nodeName(const NetworkConfig& running, int slave) { return nameIn(running, slave); }

}  // namespace syncline::ui
