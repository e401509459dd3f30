// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QList>
#include <QObject>
#include <QPalette>

class QUndoGroup;

namespace syncline::ui {

/// The actions of the window: text, shortcut, tool tip, icon. What they do is connected elsewhere.
class Actions final : public QObject {
  Q_OBJECT

 public:
  Actions(QUndoGroup& undo, QObject* parent);
  /// Draws the icons in the colours of the palette, and marks the theme that is chosen.
  void drawIcons(const QPalette& palette);

  QAction *create, *new_machine, *open, *save, *save_as, *save_template, *export_eni, *export_report, *close_recording,
      *overlay, *import_capture, *quit;
  QAction *undo, *redo, *go_to, *compare;
  QAction *demo, *scan, *choose_link, *online, *offline, *clear_statistics, *record, *save_recent, *memory, *black_box,
      *commissioning;
  QList<QAction*> states;  // INIT, PREOP, SAFEOP, OP; data() is the AlState
  QList<QAction*> themes;  // system, light, dark, high contrast; data() is the theme::Mode
  QAction *toggle_theme, *about, *reset_layout, *expert, *overview;

 private:
  QAction* add(const char* name, const QString& text, const char* icon, const QString& tool_tip,
               const QKeySequence& keys = {});

  QList<QAction*> with_icon_;
};

}  // namespace syncline::ui
