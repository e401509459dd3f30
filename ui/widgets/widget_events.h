// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace syncline::ui {

/// Sees the events of all widgets of the application before they do, and no others: what other threads have posted is
/// of no widget, and theirs until its receiver takes it, so that not even its type may be read. Every filter of the
/// application is one of these.
class WidgetEvents : public QObject {
  Q_OBJECT

 public:
  /// Watches the application.
  explicit WidgetEvents(QObject* parent);

 protected:
  /// `watched` is a widget; true: it does not get the event.
  virtual bool take(QObject& watched, QEvent& event) = 0;

 private:
  bool eventFilter(QObject* watched, QEvent* event) final;
};

}  // namespace syncline::ui
