// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "support/result.h"
#include "ui/dialogs/reading_progress.h"

class QWidget;

namespace syncline::ui {

class LiveStrip;
class OverlayBar;
class Workspace;

/// Asks for the recording that is to lie over the one that is shown, and brings it into the plots.
class WindowOverlay final : public QObject {
  Q_OBJECT

 public:
  WindowOverlay(Workspace& workspace, LiveStrip& strip, OverlayBar& bar, QWidget& window);

  void ask();
  /// Reads this one, or says why it cannot.
  void open(const QString& path);

 Q_SIGNALS:
  /// What could not be done: a sentence for the status bar.
  void refused(const QString& why);

 private:
  void show();
  void fail(const QString& path, const Error& error);

  Workspace& workspace_;
  LiveStrip& strip_;
  QWidget& window_;
  ReadingProgress progress_;
};

}  // namespace syncline::ui
