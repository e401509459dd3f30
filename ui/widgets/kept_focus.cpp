// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/kept_focus.h"

#include <QEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <algorithm>

namespace syncline::ui {
namespace {

/// Whether it keeps the focus itself, and can.
bool canHold(const QWidget& widget) {
  return widget.isEnabled() && widget.isVisible() && widget.focusProxy() == nullptr;
}

/// The nearest around it that can; nobody in a window that goes or is disabled whole.
QWidget* holderOf(const QWidget& owner) {
  if (owner.isWindow()) return nullptr;
  auto* up = owner.parentWidget();
  while (up != nullptr && !canHold(*up)) up = up->isWindow() ? nullptr : up->parentWidget();
  return up;
}

bool isOnTheWay(const QWidget& widget) {
  return canHold(widget) && (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

}  // namespace

bool KeptFocus::take(QObject& watched, QEvent& event) {
  auto& widget = static_cast<QWidget&>(watched);
  switch (event.type()) {
    case QEvent::FocusIn:
      comesBackTo(*widget.window());
      return false;
    case QEvent::FocusOut:
      onFocusOut(widget, static_cast<QFocusEvent&>(event).reason() == Qt::ActiveWindowFocusReason);
      return false;
    case QEvent::EnabledChange:
      onEnabledChange(widget);
      return false;
    case QEvent::KeyPress: {
      const auto key = static_cast<QKeyEvent&>(event).key();
      return (key == Qt::Key_Tab || key == Qt::Key_Backtab) && goesOnFrom(widget, key == Qt::Key_Tab);
    }
    default:
      return false;
  }
}

void KeptFocus::onFocusOut(QWidget& widget, bool window_left) {
  if (!widget.isEnabled() || !widget.isVisible()) {
    hold(widget);
  } else if (window_left) {
    left_.emplace_back(&widget);
  }
}

void KeptFocus::onEnabledChange(QWidget& widget) {
  if (widget.isEnabled()) return giveBack(widget);
  // Behind a dialog the focus goes on without a word.
  if (std::erase_if(left_, [&widget](const QPointer<QWidget>& one) { return one == &widget; }) > 0) hold(widget);
}

void KeptFocus::hold(QWidget& owner) {
  auto* holder = holderOf(owner);
  if (holder == nullptr) return;
  std::erase_if(kept_, [&owner](const Kept& kept) { return !kept.owner || kept.owner->window() == owner.window(); });
  kept_.push_back({&owner, holder});
  holder->setFocus(Qt::OtherFocusReason);
}

void KeptFocus::giveBack(const QWidget& owner) {
  const auto at = std::ranges::find_if(kept_, [&owner](const Kept& kept) { return kept.owner == &owner; });
  if (at == kept_.end()) return;
  const auto kept = *at;
  kept_.erase(at);
  if (kept.holder && kept.holder == owner.window()->focusWidget()) kept.owner->setFocus(Qt::OtherFocusReason);
}

void KeptFocus::comesBackTo(const QWidget& window) {
  std::erase_if(left_, [&window](const QPointer<QWidget>& one) {
    const auto* widget = one.data();
    if (widget == nullptr) return true;
    return widget->window() == &window && widget->isEnabled();  // one that is being disabled gives it away just now
  });
}

bool KeptFocus::goesOnFrom(const QWidget& holder, bool forward) const {
  const auto at = std::ranges::find_if(kept_, [&holder](const Kept& kept) { return kept.holder == &holder; });
  if (at == kept_.end() || !at->owner || !holder.hasFocus()) return false;
  QWidget* next = at->owner;
  do next = forward ? next->nextInFocusChain() : next->previousInFocusChain();
  while (next != at->owner && !isOnTheWay(*next));
  if (next == at->owner) return false;
  next->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

}  // namespace syncline::ui
