// SPDX-License-Identifier: Apache-2.0
#include "ui/text/signal_text.h"

#include <QCoreApplication>

namespace syncline::ui {

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
    case Signal::kDeviation:
      return QCoreApplication::translate("DistributionView", "Largest deviation");
    case Signal::kDeviationOred:
      return QCoreApplication::translate("DistributionView", "Deviation, or-ed");
    case Signal::kNetworkToSlave:
      return QCoreApplication::translate("DistributionView", "Network to slave");
    case Signal::kMasterToNetwork:
      return QCoreApplication::translate("DistributionView", "Master to network");
    case Signal::kFrameLateBy:
      return QCoreApplication::translate("DistributionView", "Frame late by");
    case Signal::kSlaveDeviation:
      return QCoreApplication::translate("DistributionView", "Deviation");
    case Signal::kArrivalPhase:
      return QCoreApplication::translate("DistributionView", "Arrival phase");
    default:
      return {};
  }
}

}  // namespace syncline::ui
