// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/signal_source.h"

#include <fmt/format.h>

#include "ui/text/signal_text.h"

namespace syncline::ui {
namespace {

using Scope = SignalInfo::Scope;

bool isOfSlave(Signal signal) { return info(signal).scope == Scope::kSlave; }
bool isOfVariable(Signal signal) { return info(signal).scope == Scope::kVariable; }

}  // namespace

bool isThere(const RunRecord& record, const SignalSource& source) {
  if (isOfSlave(source.signal)) return source.slave < record.samples().slave_count();
  return !isOfVariable(source.signal) || source.slave < record.watched().variables().size();
}

const MinMaxSeries& seriesOf(const RunRecord& record, const SignalSource& source) {
  return info(source.signal).scope == Scope::kBus ? record.samples().series(source.signal)
                                                  : record.samples().series(source.signal, source.slave);
}

QString nameOf(const RunRecord& record, const SignalSource& source) {
  if (isOfVariable(source.signal)) return QString::fromStdString(record.watched().variables().at(source.slave).name);
  if (!isOfSlave(source.signal)) return signalText(source.signal);
  const auto slave =
      u'#' + QString::number(source.slave) + u' ' + QString::fromStdString(record.slave_name(source.slave));
  return source.signal == Signal::kArrivalPhase ? slave + QStringLiteral(": ") + signalText(source.signal) : slave;
}

std::string keyOf(const RunRecord& record, const SignalSource& source) {
  if (isOfVariable(source.signal)) return record.watched().variables().at(source.slave).name;
  const auto key = info(source.signal).key;
  return isOfSlave(source.signal) ? fmt::format("{} #{}", key, source.slave) : std::string(key);
}

double limitOf(const RunLimits& limits, Signal signal) { return limit_of(limits, signal); }

bool isMagnitude(Signal signal) {
  return signal == Signal::kDeviation || signal == Signal::kDeviationOred || signal == Signal::kNetworkToSlave;
}

}  // namespace syncline::ui
