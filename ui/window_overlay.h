// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "support/result.h"

class QProgressDialog;
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
  void endProgress();
  void fail(const QString& path, const Error& error);

  Workspace& workspace_;
  LiveStrip& strip_;
  QWidget& window_;
  QPointer<QProgressDialog> progress_;
};

}  // namespace syncline::ui
