// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/signal_source.h"

#include <fmt/format.h>

#include "ui/text/signal_text.h"

namespace syncline::ui {
namespace {

bool isOfSlave(Signal signal) { return info(signal).scope == SignalInfo::Scope::kSlave; }

}  // namespace

const MinMaxSeries& seriesOf(const RunRecord& record, const SignalSource& source) {
  return isOfSlave(source.signal) ? record.samples().series(source.signal, source.slave)
                                  : record.samples().series(source.signal);
}

QString nameOf(const RunRecord& record, const SignalSource& source) {
  if (!isOfSlave(source.signal)) return signalText(source.signal);
  const auto slave =
      u'#' + QString::number(source.slave) + u' ' + QString::fromStdString(record.slave_name(source.slave));
  return source.signal == Signal::kArrivalPhase ? slave + QStringLiteral(": ") + signalText(source.signal) : slave;
}

std::string keyOf(const SignalSource& source) {
  const auto key = info(source.signal).key;
  return isOfSlave(source.signal) ? fmt::format("{} #{}", key, source.slave) : std::string(key);
}

double limitOf(const RunLimits& limits, Signal signal) { return limit_of(limits, signal); }

bool isMagnitude(Signal signal) {
  return signal == Signal::kDeviation || signal == Signal::kDeviationOred || signal == Signal::kNetworkToSlave;
}

}  // namespace syncline::ui
