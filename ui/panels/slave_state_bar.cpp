// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/slave_state_bar.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>

#include "ui/dialogs/slave_state_commands.h"
#include "ui/session/running_slave.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

SlaveStateBar::SlaveStateBar(Workspace& workspace, SlaveStateCommands& commands, QWidget* parent)
    : QWidget(parent), workspace_(workspace), commands_(commands) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 0, 14, 6);
  layout->setSpacing(4);
  text_ = named(new ValueLabel, "slaveStatus", tr("AL status of the slave"));
  text_->setMinimumWidth(60);
  layout->addWidget(text_, 1);
  acknowledge_ = named(new QPushButton(tr("Acknowledge Error")), "slaveAcknowledgeError", tr("Acknowledge the error"));
  acknowledge_->setToolTip(tr("Writes the error acknowledge bit (0x0120 bit 4); the slave stays in its state"));
  layout->addWidget(acknowledge_);
  for (const auto state : {AlState::kBoot, AlState::kInit, AlState::kPreop, AlState::kSafeop, AlState::kOp}) {
    const auto name = stateName(state);
    auto* button = new QPushButton(name);
    button->setObjectName(QStringLiteral("slaveRequest") + name);
    button->setAccessibleName(tr("Request %1 of this slave").arg(name));
    button->setToolTip(tr("Leads this slave alone to %1, with its init commands (register 0x0120)").arg(name));
    button->setCheckable(true);
    layout->addWidget(button);
    states_.insert(static_cast<int>(state), button);
    connect(button, &QPushButton::clicked, this, [this, state] {
      commands_.request(slave_, state);
      showLive();
    });
  }
  connect(acknowledge_, &QPushButton::clicked, this, [this] { commands_.acknowledge(slave_); });
  connect(&commands_, &SlaveStateCommands::told, this, [this](int slave, const QString& text, bool bad) {
    if (slave != slave_ || slave < 0) return;
    answer_ = text;
    bad_ = bad;
    answer_position_ = workspace_.runningSlaves().positionOf(slave);
    answer_status_ = statusNow();
    answer_time_ = workspace_.live().snapshot().time;
    showLive();
  });
  setSlave(-1);
}

void SlaveStateBar::setSlave(int slave) {
  // The same slave may have another number by now.
  if (slave != slave_ && answer_position_ < 0) answer_.clear();
  slave_ = slave;
  showLive();
}

/// "SAFEOP + ERR, 0x001B: sync manager watchdog"
QString SlaveStateBar::status(bool whole) const {
  const auto running = runningSlave(workspace_, slave_);
  if (!running) return tr("The machine was started without this slave.");
  if (!running->present()) return tr("No answer (register 0x0130)");
  const auto status = running->status->al_status;
  auto text =
      whole ? tr("AL status %1: %2").arg(hexText(status, 4), stateName(running->state())) : stateName(running->state());
  if ((status & kAlErrorFlag) == 0) return text;
  const auto code = running->status->al_status_code;
  const auto words = al_status_code_text(code);
  text += QStringLiteral(" + ERR, %1 %2").arg(hexText(code, 4), fromView(words.meaning));
  return words.check.empty() || !whole ? text : text + QStringLiteral(" \u2013 ") + fromView(words.check);
}

std::uint16_t SlaveStateBar::statusNow() const {
  const auto running = runningSlave(workspace_, slave_);
  return running && running->present() ? running->status->al_status : std::uint16_t{0};
}

/// An answer is about the slave as it was then. The AL status that came with a refusal is seen a little later than the
/// refusal, and somebody has to read that.
void SlaveStateBar::ageAnswer() {
  constexpr Nanoseconds kSettles = kSecond, kLongest = 30 * kSecond;
  if (answer_.isEmpty()) return;
  const auto age = workspace_.live().snapshot().time - answer_time_;
  const auto now = statusNow();
  if (bad_ && age < kSettles) answer_status_ = now;
  const bool other = workspace_.runningSlaves().positionOf(slave_) != answer_position_;
  if (other || now != answer_status_ || age > kLongest) answer_.clear();
}

void SlaveStateBar::showLive() {
  setVisible(slave_ >= 0 && workspace_.live().snapshot().online);
  if (!workspace_.live().snapshot().online) answer_.clear();
  if (isHidden()) return;
  ageAnswer();
  const auto running = runningSlave(workspace_, slave_);
  const bool failed = commands_.failed(slave_);
  const auto said = [this](bool whole) {
    return answer_.isEmpty() ? status(whole) : QStringLiteral("%1 \u2013 %2").arg(answer_, status(whole));
  };
  text_->setText(said(true), said(false));
  auto colors = palette();
  const bool red = failed || (bad_ && !answer_.isEmpty());
  if (red) colors.setColor(QPalette::WindowText, theme::toneColor(colors, theme::Tone::kBad));
  text_->setPalette(colors);
  const bool possible = commands_.obstacle(slave_).isEmpty();
  const auto states = commands_.states(slave_);
  for (auto at = states_.cbegin(); at != states_.cend(); ++at) {
    const auto state = static_cast<AlState>(at.key());
    at.value()->setVisible(std::ranges::find(states, state) != states.end());
    at.value()->setEnabled(possible);
    at.value()->setChecked(running && running->state() == state);
  }
  acknowledge_->setVisible(failed);
  acknowledge_->setEnabled(possible);
}

}  // namespace syncline::ui
