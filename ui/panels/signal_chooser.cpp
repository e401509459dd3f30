// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/signal_chooser.h"

#include <QMenu>
#include <algorithm>
#include <utility>

#include "ui/text/signal_text.h"

namespace syncline::ui {

SignalChooser::SignalChooser(bool (*suits)(const SignalInfo&), QWidget* parent) : QToolButton(parent), suits_(suits) {
  setText(tr("Signals"));
  setToolTip(tr("Up to four signals over each other"));
  setPopupMode(InstantPopup);
  setMenu(new QMenu(this));
  connect(menu(), &QMenu::aboutToShow, this, &SignalChooser::fill);
}

void SignalChooser::setRecord(const RunRecord* record) {
  record_ = record;
  if (record == nullptr) return;
  std::erase_if(sources_, [&](const SignalSource& source) {
    return info(source.signal).scope == SignalInfo::Scope::kSlave && source.slave >= record->samples().slave_count();
  });
}

void SignalChooser::setSources(std::vector<SignalSource> sources) {
  sources.resize(std::min(sources.size(), kMost));
  sources_ = std::move(sources);
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
}

}  // namespace syncline::ui
