// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/signal_chooser.h"

#include <QMenu>
#include <algorithm>
#include <utility>

#include "record/run_record.h"
#include "ui/text/signal_text.h"

namespace syncline::ui {

SignalChooser::SignalChooser(bool (*suits)(const SignalInfo&), QWidget* parent) : QToolButton(parent), suits_(suits) {
  setText(tr("Signals"));
  setToolTip(tr("Up to four signals over each other"));
  setPopupMode(InstantPopup);
  setMenu(new QMenu(this));
  connect(menu(), &QMenu::aboutToShow, this, &SignalChooser::fill);
}

void SignalChooser::setRecord(const RunRecord* record, bool recorded) {
  record_ = record;
  recorded_ = recorded;
  if (record == nullptr) return;
  const auto& there = record->watched().variables();
  auto variable = variables_.begin();
  for (auto& source : sources_) {
    if (source.signal != Signal::kVariable) continue;
    source.slave = static_cast<std::size_t>(std::ranges::find(there, *variable++) - there.begin());
  }
  std::erase_if(sources_, [&](const SignalSource& source) { return !isThere(*record, source); });
  std::erase_if(variables_, [&](const WatchedVariable& one) { return std::ranges::find(there, one) == there.end(); });
}

void SignalChooser::setSources(std::vector<SignalSource> sources) {
  std::erase_if(sources, [this](const SignalSource& source) {
    return record_ == nullptr ? source.signal == Signal::kVariable : !isThere(*record_, source);
  });
  sources.resize(std::min(sources.size(), kMost));
  sources_ = std::move(sources);
  variables_.clear();
  for (const auto& source : sources_) {
    if (source.signal == Signal::kVariable) variables_.push_back(record_->watched().variables()[source.slave]);
  }
  Q_EMIT changed();
}

void SignalChooser::offer(QMenu& menu, const QString& text, const SignalSource& source) {
  auto* action = menu.addAction(text);
  const bool chosen = std::ranges::find(sources_, source) != sources_.end();
  action->setCheckable(true);
  action->setChecked(chosen);
  action->setEnabled(chosen ? sources_.size() > 1 : sources_.size() < kMost);
  connect(action, &QAction::triggered, this, [this, source](bool on) {
    auto sources = sources_;
    std::erase(sources, source);
    if (on) sources.push_back(source);
    setSources(std::move(sources));
  });
}

void SignalChooser::fill() {
  menu()->clear();
  if (record_ == nullptr) return;
  for (const auto& row : signals()) {
    const auto text = signalText(row.id);
    if (!text.isEmpty() && row.scope == SignalInfo::Scope::kBus && suits_(row)) offer(*menu(), text, {row.id, 0});
  }
  auto* slaves = menu()->addMenu(tr("Deviation of a slave"));
  auto* phases = suits_(info(Signal::kArrivalPhase)) ? menu()->addMenu(tr("Arrival phase of a slave")) : nullptr;
  for (std::size_t slave = 0; slave < record_->samples().slave_count(); ++slave) {
    const SignalSource deviation{Signal::kSlaveDeviation, slave};
    if (!seriesOf(*record_, deviation).empty()) offer(*slaves, nameOf(*record_, deviation), deviation);
    // Not asked for its series, which would be made now.
    const SignalSource phase{Signal::kArrivalPhase, slave};
    if (phases != nullptr && record_->samples().sync0(slave).period > 0) offer(*phases, nameOf(*record_, phase), phase);
  }
  // Where no slave has SYNC0 it would open nothing.
  if (phases != nullptr) phases->menuAction()->setVisible(!phases->isEmpty());
  if (suits_(info(Signal::kVariable))) fillVariables(*menu()->addMenu(tr("Variable of the process image")));
}

void SignalChooser::fillVariables(QMenu& menu) {
  for (std::size_t number = 0; number < record_->watched().variables().size(); ++number) {
    const SignalSource variable{Signal::kVariable, number};
    offer(menu, nameOf(*record_, variable), variable);
  }
  if (!recorded_) {
    menu.addSeparator();
    menu.addAction(tr("Watch others…"), this, &SignalChooser::variablesWanted);
  }
  menu.menuAction()->setVisible(!menu.isEmpty());
}

}  // namespace syncline::ui
