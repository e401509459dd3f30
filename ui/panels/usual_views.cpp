// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/usual_views.h"

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include "record/run_record.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/view_signals.h"

namespace syncline::ui {
namespace {

std::string words(const char* text) { return QCoreApplication::translate("FreeView", text).toStdString(); }

ViewPlot plotOf(const RunRecord& record, std::initializer_list<Signal> left, std::initializer_list<Signal> right = {}) {
  ViewPlot plot;
  for (const auto signal : left) plot.signals.push_back(viewSignalOf(record, {signal, 0}));
  for (const auto signal : right) {
    plot.signals.push_back(viewSignalOf(record, {signal, 0}));
    plot.signals.back().right = true;
  }
  return plot;
}

/// Of a machine that has one: a table from somewhere may have its values without the settings.
bool hasExternalClock(const RunRecord& record) {
  const auto& dc = record.config().dc;
  return (dc.enabled && dc.dcm.mode == DcmMode::kDcx) ||
         record.samples().series(Signal::kExternalError).extent(INT64_MIN, INT64_MAX);
}

MonitorView dcmView(const RunRecord& record) {
  MonitorView view{words(QT_TRANSLATE_NOOP("FreeView", "DCM: error, adjustment, drift")), {}};
  view.plots.push_back(plotOf(record, {Signal::kDcmError, Signal::kDcmErrorFiltered}));
  view.plots.back().title = words(QT_TRANSLATE_NOOP("FreeView", "DCM error"));
  if (hasExternalClock(record)) {
    view.plots.push_back(plotOf(record, {Signal::kExternalError}));
    view.plots.back().title = words(QT_TRANSLATE_NOOP("FreeView", "External clock"));
  }
  view.plots.push_back(plotOf(record, {Signal::kDcmAdjust}, {Signal::kDrift}));
  view.plots.back().title = words(QT_TRANSLATE_NOOP("FreeView", "Adjustment and drift"));
  return view;
}

MonitorView stateView(const RunRecord& record) {
  MonitorView view{words(QT_TRANSLATE_NOOP("FreeView", "AL states of all slaves")), {}};
  auto states = plotOf(record, {Signal::kMasterState, Signal::kSlavesSync, Signal::kMasterSync});
  states.title = words(QT_TRANSLATE_NOOP("FreeView", "States"));
  const auto slaves = record.samples().slave_count();
  for (std::size_t slave = 0; slave < slaves; ++slave)
    states.signals.push_back(viewSignalOf(record, {Signal::kAlState, slave}));
  view.plots.push_back(std::move(states));
  return view;
}

MonitorView frameView(const RunRecord& record) {
  MonitorView view{words(QT_TRANSLATE_NOOP("FreeView", "Frames of the bus")), {}};
  view.plots.push_back(plotOf(record, {Signal::kRoundTrip, Signal::kLateness}));
  view.plots.back().title = words(QT_TRANSLATE_NOOP("FreeView", "Round trip and send lateness"));
  view.plots.push_back(
      plotOf(record, {Signal::kLostFrames, Signal::kLateFrames, Signal::kLeftOutCycles, Signal::kWkcErrors}));
  view.plots.back().title = words(QT_TRANSLATE_NOOP("FreeView", "Counts of the bus"));
  return view;
}

/// What it has: a count that nobody reads of it would be a name without a curve.
MonitorView counterView(const RunRecord& record, std::size_t slave) {
  const auto owner = ownerOf(record, viewSignalOf(record, {Signal::kAlState, slave}));
  MonitorView view{QCoreApplication::translate("FreeView", "Counters of %1").arg(owner).toStdString(), {}};
  ViewPlot ports, others;
  ports.title = words(QT_TRANSLATE_NOOP("FreeView", "Errors at the ports"));
  others.title = words(QT_TRANSLATE_NOOP("FreeView", "Counts of the device"));
  for (const auto& row : signals()) {
    if (row.scope != SignalInfo::Scope::kSlave || row.form != SignalInfo::Form::kHeld || row.since.empty()) continue;
    if (record.samples().series(row.id, slave).empty()) continue;
    const bool of_port = row.id >= Signal::kPortErrors && row.id < Signal::kSyncBase;
    (of_port ? ports : others).signals.push_back(viewSignalOf(record, {row.id, slave}));
  }
  // The fuse is a level, no count: it says something beside where it trips.
  ViewPlot fuse;
  fuse.title = words(QT_TRANSLATE_NOOP("FreeView", "Fuse and its limit"));
  for (const auto signal : {Signal::kSm2Integrator, Signal::kSm2Limit}) {
    if (!record.samples().series(signal, slave).empty()) fuse.signals.push_back(viewSignalOf(record, {signal, slave}));
  }
  if (!fuse.signals.empty()) view.plots.push_back(std::move(fuse));
  if (!ports.signals.empty()) view.plots.push_back(std::move(ports));
  if (!others.signals.empty()) view.plots.push_back(std::move(others));
  return view;
}

}  // namespace

MonitorView viewOf(const RunRecord& record, const std::vector<SignalSource>& sources) {
  MonitorView view;
  for (const auto& source : sources) {
    auto signal = viewSignalOf(record, source);
    const auto alike = std::ranges::find_if(view.plots, [&](const ViewPlot& plot) {
      const auto& first = plot.signals.front();
      return isState(first) == isState(signal) && unitOf(first) == unitOf(signal);
    });
    if (alike != view.plots.end()) {
      alike->signals.push_back(std::move(signal));
    } else {
      view.plots.push_back({});
      view.plots.back().signals.push_back(std::move(signal));
    }
  }
  return view;
}

std::vector<MonitorView> usualViews(const RunRecord& record, int slave) {
  std::vector<MonitorView> views{dcmView(record), stateView(record), frameView(record)};
  const auto slaves = record.samples().slave_count();
  const auto chosen = static_cast<std::size_t>(std::max(slave, 0));
  if (chosen < slaves) views.push_back(counterView(record, chosen));
  return views;
}

}  // namespace syncline::ui
