// SPDX-License-Identifier: Apache-2.0
#include "ui/text/signal_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "ui/text/state_text.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString words(const char* text) { return QCoreApplication::translate("Signals", text); }

/// Of the sixteen counts of a slave's ports.
QString portSignal(Signal signal) {
  const auto number = static_cast<int>(signal) - static_cast<int>(Signal::kPortErrors);
  if (number < 0 || number >= static_cast<int>(kPorts * kPortSignals)) return {};
  const auto port = number / static_cast<int>(kPortSignals);
  switch (static_cast<PortSignal>(number % static_cast<int>(kPortSignals))) {
    case PortSignal::kInvalidFrames:
      return words(QT_TRANSLATE_NOOP("Signals", "Port %1: invalid frames")).arg(port);
    case PortSignal::kReceiveErrors:
      return words(QT_TRANSLATE_NOOP("Signals", "Port %1: receive errors")).arg(port);
    case PortSignal::kForwardedErrors:
      return words(QT_TRANSLATE_NOOP("Signals", "Port %1: forwarded errors")).arg(port);
    case PortSignal::kLostLinks:
      return words(QT_TRANSLATE_NOOP("Signals", "Port %1: lost links")).arg(port);
  }
  return {};
}

}  // namespace

QString signalText(Signal signal) {
  switch (signal) {
    case Signal::kLateness:
      return QCoreApplication::translate("DistributionView", "Send lateness");
    case Signal::kRoundTrip:
      return QCoreApplication::translate("DistributionView", "Round trip");
    case Signal::kDcmError:
      return QCoreApplication::translate("DistributionView", "DCM error");
    case Signal::kDcmErrorFiltered:
      return QCoreApplication::translate("DistributionView", "DCM error, filtered");
    case Signal::kFrameError:
      return QCoreApplication::translate("DistributionView", "DCM error with lateness");
    case Signal::kDrift:
      return QCoreApplication::translate("DistributionView", "Drift");
    case Signal::kDcmAdjust:
      return QCoreApplication::translate("DistributionView", "Adjustment");
    case Signal::kDcmOutputSum:
      return QCoreApplication::translate("DistributionView", "Learned by the controller, a cycle");
    case Signal::kDcmOutputTotal:
      return QCoreApplication::translate("DistributionView", "All adjustments");
    case Signal::kDeviation:
      return QCoreApplication::translate("DistributionView", "Largest deviation");
    case Signal::kDeviationOred:
      return QCoreApplication::translate("DistributionView", "Deviation, or-ed (upper estimate)");
    case Signal::kNetworkToSlave:
      return QCoreApplication::translate("DistributionView", "Network to slave");
    case Signal::kMasterToNetwork:
      return QCoreApplication::translate("DistributionView", "Master to network");
    case Signal::kFrameLateBy:
      return QCoreApplication::translate("DistributionView", "Frame late by");
    case Signal::kStampDoubt:
      return QCoreApplication::translate("DistributionView", "Doubt of the send stamp");
    case Signal::kExternalError:
      return QCoreApplication::translate("DistributionView", "Reference clock against external clock");
    case Signal::kSlaveDeviation:
      return QCoreApplication::translate("DistributionView", "Deviation");
    case Signal::kArrivalPhase:
      return QCoreApplication::translate("DistributionView", "Arrival phase");
    default:
      return {};
  }
}

QString signalName(Signal signal) {
  switch (signal) {
    case Signal::kWkcExpected:
      return words(QT_TRANSLATE_NOOP("Signals", "Working counter, expected"));
    case Signal::kWkcReceived:
      return words(QT_TRANSLATE_NOOP("Signals", "Working counter, received"));
    case Signal::kFramesLost:
      return words(QT_TRANSLATE_NOOP("Signals", "Frames lost in a cycle"));
    case Signal::kSkippedCycles:
      return words(QT_TRANSLATE_NOOP("Signals", "Cycles left out before a cycle"));
    case Signal::kSlavesSync:
      return words(QT_TRANSLATE_NOOP("Signals", "Synchronisation of the slaves"));
    case Signal::kMasterSync:
      return words(QT_TRANSLATE_NOOP("Signals", "Synchronisation of the master"));
    case Signal::kMasterState:
      return words(QT_TRANSLATE_NOOP("Signals", "Lowest AL state of all slaves"));
    case Signal::kLostFrames:
      return words(QT_TRANSLATE_NOOP("Signals", "Lost frames"));
    case Signal::kLateFrames:
      return words(QT_TRANSLATE_NOOP("Signals", "Late frames"));
    case Signal::kLeftOutCycles:
      return words(QT_TRANSLATE_NOOP("Signals", "Cycles left out"));
    case Signal::kWkcErrors:
      return words(QT_TRANSLATE_NOOP("Signals", "Wrong working counters"));
    case Signal::kLateSends:
      return words(QT_TRANSLATE_NOOP("Signals", "Frames too late for SYNC0"));
    case Signal::kSm2Missed:
      return words(QT_TRANSLATE_NOOP("Signals", "SM2 events missed"));
    case Signal::kSm2Integrator:
      return words(QT_TRANSLATE_NOOP("Signals", "Fuse of the SM2 events"));
    case Signal::kSm2Limit:
      return words(QT_TRANSLATE_NOOP("Signals", "Limit of the fuse"));
    case Signal::kSm2CyclesToTrip:
      return words(QT_TRANSLATE_NOOP("Signals", "Misses until the fuse trips"));
    case Signal::kOutputsExceeded:
      return words(QT_TRANSLATE_NOOP("Signals", "Cycle exceeded, outputs"));
    case Signal::kInputsExceeded:
      return words(QT_TRANSLATE_NOOP("Signals", "Cycle exceeded, inputs"));
    case Signal::kOutputsShiftTooShort:
      return words(QT_TRANSLATE_NOOP("Signals", "Shift too short, outputs"));
    case Signal::kInputsShiftTooShort:
      return words(QT_TRANSLATE_NOOP("Signals", "Shift too short, inputs"));
    case Signal::kClockRate:
      return words(QT_TRANSLATE_NOOP("Signals", "Clock slowed by"));
    case Signal::kAlState:
      return words(QT_TRANSLATE_NOOP("Signals", "AL state"));
    case Signal::kProcessDataWatchdog:
      return words(QT_TRANSLATE_NOOP("Signals", "Process data watchdog"));
    case Signal::kPdiWatchdog:
      return words(QT_TRANSLATE_NOOP("Signals", "PDI watchdog"));
    case Signal::kProcessingUnitErrors:
      return words(QT_TRANSLATE_NOOP("Signals", "Processing unit errors"));
    case Signal::kPdiErrors:
      return words(QT_TRANSLATE_NOOP("Signals", "PDI errors"));
    case Signal::kPropagationDelay:
      return words(QT_TRANSLATE_NOOP("Signals", "Propagation delay"));
    case Signal::kSetpointSlips:
      return words(QT_TRANSLATE_NOOP("Signals", "Setpoint slips"));
    case Signal::kVariable:
      return words(QT_TRANSLATE_NOOP("Signals", "Variable"));
    case Signal::kCountsAtLeast:
      return words(QT_TRANSLATE_NOOP("Signals", "Counts that may be higher"));
    default:
      break;
  }
  const auto port = portSignal(signal);
  return port.isEmpty() ? signalText(signal) : port;
}

QString signalValue(Signal signal, double value) {
  const auto& row = info(signal);
  if (row.scale == SignalInfo::Scale::kBand) return stateText(signal, static_cast<int>(value)).text;
  if (row.unit == "ns") return signedTimeText(static_cast<Nanoseconds>(std::llround(value)));
  if (row.unit == "ppm") return ppmText(value);
  return numberText(value);
}

}  // namespace syncline::ui
