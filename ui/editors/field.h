// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFocusEvent>
#include <QKeyEvent>
#include <QWidget>

namespace syncline::ui {

/// A control into which something can be typed that is not in the project yet.
class Field {
 public:
  virtual ~Field() = default;
  /// Text was typed and neither taken nor given up.
  [[nodiscard]] virtual bool pending() const = 0;
  /// Offers what was typed as a value. False when it was refused: the text stays and is marked.
  virtual bool commit() = 0;
  /// Gives up what was typed.
  virtual void revert() = 0;
};

/// The field that `widget` is or belongs to; null when there is none.
[[nodiscard]] Field* fieldOf(QWidget* widget);

/// A key that belongs to a command of the window (an enabled action with that shortcut: undo, redo, export ...) must
/// not be taken by the field for itself. True: that was it, and the event is over for the field.
[[nodiscard]] bool leavesToCommand(const QWidget& field, QEvent& event);

/// What a field does on a key, by itself.
enum class FieldKey {
  kNone,     // nothing: it is typing
  kTaken,    // Enter, the value was taken
  kRefused,  // Enter, but it was not
  kGivenUp,  // Escape
};
/// Enter offers what was typed, Escape gives it up where something is pending; the event is accepted then.
FieldKey takeKey(Field& field, QKeyEvent& event);

/// A menu that opens over the field does not end the typing.
[[nodiscard]] inline bool leavesField(const QFocusEvent& event) { return event.reason() != Qt::PopupFocusReason; }

/// Marks the control and says why; empty: unmarks it.
void markField(QWidget& field, const QString& reason);
/// Marks the control whose text was not taken and tells why below it at once, without the pointer being there.
void refuseText(QWidget& field, const QString& reason);

}  // namespace syncline::ui
