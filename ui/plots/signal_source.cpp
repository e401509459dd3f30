// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/signal_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/monitor_view.h"
#include "record/run_record.h"
#include "trace/min_max_series.h"
#include "trace/sync_overview.h"
#include "ui/text/signal_text.h"

namespace syncline::ui {
namespace {

using Scope = SignalInfo::Scope;

bool isOfSlave(Signal signal) { return info(signal).scope == Scope::kSlave; }
bool isOfVariable(Signal signal) { return info(signal).scope == Scope::kVariable; }

}  // namespace

std::uint16_t stationOf(const RunRecord& record, std::size_t slave) {
  constexpr std::size_t kFirst = 1001;
  const auto& slaves = record.config().slaves;
  const auto told = slave < slaves.size() ? slaves[slave].station_address : std::uint16_t{0};
  return told != 0 ? told : static_cast<std::uint16_t>(kFirst + slave);
}

std::optional<std::size_t> slaveOf(const RunRecord& record, std::uint16_t station) {
  for (std::size_t slave = 0; slave < record.samples().slave_count(); ++slave) {
    if (stationOf(record, slave) == station) return slave;
  }
  return std::nullopt;
}

std::optional<SignalSource> sourceOf(const RunRecord& record, const ViewSignal& signal) {
  if (signal.of == ViewSignal::Of::kVariable) {
    const auto& variables = record.watched().variables();
    const auto found = std::ranges::find_if(variables, [&](const WatchedVariable& variable) {
      return variable.name == signal.key && variable.output == signal.output;
    });
    if (found == variables.end()) return std::nullopt;
    return SignalSource{Signal::kVariable, static_cast<std::size_t>(found - variables.begin())};
  }
  const auto* row = find_signal(signal.key, signal.of == ViewSignal::Of::kBus ? Scope::kBus : Scope::kSlave);
  if (row == nullptr || row->form == SignalInfo::Form::kCell) return std::nullopt;
  if (signal.of == ViewSignal::Of::kBus) return SignalSource{row->id, 0};
  const auto slave = slaveOf(record, signal.station_address);
  return slave ? std::optional(SignalSource{row->id, *slave}) : std::nullopt;
}

ViewSignal viewSignalOf(const RunRecord& record, const SignalSource& source) {
  ViewSignal signal;
  if (isOfVariable(source.signal)) {
    const auto& variable = record.watched().variables().at(source.slave);
    signal.of = ViewSignal::Of::kVariable;
    signal.key = variable.name;
    signal.output = variable.output;
    return signal;
  }
  signal.key = info(source.signal).key;
  if (!isOfSlave(source.signal)) return signal;
  signal.of = ViewSignal::Of::kSlave;
  signal.station_address = stationOf(record, source.slave);
  return signal;
}

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

bool isUpperEstimate(const RunRecord& record, Signal signal) {
  if (signal == Signal::kDeviation) return record.overview().is_deviation_ored();
  return signal == Signal::kDeviationOred;
}

}  // namespace syncline::ui
