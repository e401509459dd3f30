// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "ui/widgets/widget_events.h"

namespace syncline::ui {

/// While it lives, a widget that is disabled or hidden while it has the focus (a button that is busy, the arrow of a
/// list at its end, a field of a page that goes) does not give the focus to its neighbour, which would take what is
/// typed next: what it stands in keeps the focus, where keys edit and press nothing. As soon as the widget can be used
/// again it has the focus back, unless the user went elsewhere; Tab goes on from where it stands.
class KeptFocus final : public WidgetEvents {
  Q_OBJECT

 public:
  using WidgetEvents::WidgetEvents;

 protected:
  bool take(QObject& watched, QEvent& event) override;

 private:
  struct Kept {
    QPointer<QWidget> owner, holder;
  };

  void onFocusOut(QWidget& widget, bool window_left);
  void onEnabledChange(QWidget& widget);
  void hold(QWidget& owner);
  void giveBack(const QWidget& owner);
  void comesBackTo(const QWidget& window);
  [[nodiscard]] bool goesOnFrom(const QWidget& holder, bool forward) const;

  std::vector<Kept> kept_;
  std::vector<QPointer<QWidget>> left_;  // one of each window that is not active: what has the focus there
};

}  // namespace syncline::ui
