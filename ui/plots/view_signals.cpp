// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/view_signals.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "record/run_record.h"
#include "ui/plots/signal_source.h"
#include "ui/text/signal_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString words(const char* text) { return QCoreApplication::translate("FreeView", text); }

QString unitWord(const QString& unit) {
  if (unit == QStringLiteral("ns")) return words(QT_TRANSLATE_NOOP("FreeView", "Time"));
  if (unit == QStringLiteral("ppm")) return words(QT_TRANSLATE_NOOP("FreeView", "Rate of a clock"));
  if (unit == QStringLiteral("1/s")) return words(QT_TRANSLATE_NOOP("FreeView", "Events"));
  return words(QT_TRANSLATE_NOOP("FreeView", "Value"));
}

}  // namespace

const SignalInfo* rowOf(const ViewSignal& signal) {
  if (signal.of == ViewSignal::Of::kVariable) return nullptr;
  return find_signal(signal.key,
                     signal.of == ViewSignal::Of::kBus ? SignalInfo::Scope::kBus : SignalInfo::Scope::kSlave);
}

QString ownerOf(const RunRecord& record, const ViewSignal& signal) {
  if (signal.of != ViewSignal::Of::kSlave) return {};
  const auto slave = slaveOf(record, signal.station_address);
  if (!slave) return QString::number(signal.station_address);
  return u'#' + QString::number(*slave) + u' ' + QString::fromStdString(record.slave_name(*slave));
}

QString quantityOf(const ViewSignal& signal) {
  const auto* row = rowOf(signal);
  const auto name = row == nullptr ? QString::fromStdString(signal.key) : signalName(row->id);
  return signal.rate ? words(QT_TRANSLATE_NOOP("FreeView", "%1, a second")).arg(name) : name;
}

QString nameOf(const RunRecord& record, const ViewSignal& signal) {
  const auto owner = ownerOf(record, signal);
  return owner.isEmpty() ? quantityOf(signal) : owner + QStringLiteral(": ") + quantityOf(signal);
}

QString unitOf(const ViewSignal& signal) {
  if (signal.rate) return QStringLiteral("1/s");
  const auto* row = rowOf(signal);
  return row == nullptr ? QString() : fromView(row->unit);
}

bool isState(const ViewSignal& signal) {
  const auto* row = rowOf(signal);
  return row != nullptr && row->scale == SignalInfo::Scale::kBand;
}

bool isCount(const ViewSignal& signal) {
  const auto* row = rowOf(signal);
  return row != nullptr && row->form == SignalInfo::Form::kHeld && !row->since.empty();
}

ValueAxis::Options axisFor(const std::vector<const ViewSignal*>& signals) {
  ValueAxis::Options options{words("Value"), ValueAxis::Quantity::kCount, 1, false};
  if (signals.empty()) return options;
  const auto unit = unitOf(*signals.front());
  const auto quantity = quantityOf(*signals.front());
  const bool same_unit = std::ranges::all_of(signals, [&](const auto* one) { return unitOf(*one) == unit; });
  const bool same = std::ranges::all_of(signals, [&](const auto* one) { return quantityOf(*one) == quantity; });
  if (!same_unit) return options;
  constexpr qsizetype kLongest = 24;  // along the axis
  options.quantity = same && quantity.size() <= kLongest ? quantity : unitWord(unit);
  if (unit == QStringLiteral("ns")) {
    options.kind = ValueAxis::Quantity::kTime;
    options.minimum_span = 20;
    return options;
  }
  options.unit = unit;
  if (unit == QStringLiteral("ppm")) {
    options.minimum_span = 0.1;
    options.least = 0.01;
  } else if (std::ranges::all_of(signals, [](const auto* one) { return isCount(*one); })) {
    options.minimum_span = 4;
    options.with_zero = true;
  }
  return options;
}

QString valueOf(const ViewSignal& signal, double value) {
  if (signal.rate) return QLocale().toString(value, 'g', 4) + QChar(0x00A0) + QStringLiteral("1/s");
  const auto* row = rowOf(signal);
  return row == nullptr ? numberText(value) : signalValue(row->id, value);
}

}  // namespace syncline::ui
