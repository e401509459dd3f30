// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <QString>
#include <functional>

class QProgressDialog;
class QWidget;

namespace syncline::ui {

/// How far a long reading is, with Cancel; shown when it takes long.
class ReadingProgress final {
 public:
  explicit ReadingProgress(QWidget& window) : window_(window) {}

  /// `name`: of the object; `title`: what is done with the file; `cancel` is called when the user asks for it.
  void begin(const QString& path, const char* name, const QString& title, std::function<void()> cancel);
  /// Thousandths.
  void set(int permille);
  /// Shown at once, with this in place of its words, as large as it wants to be; it belongs to the dialog then.
  void show(QWidget* picture);
  /// Hidden at once: until it is deleted it would take the keys of the window.
  void end();

 private:
  QWidget& window_;
  QPointer<QProgressDialog> dialog_;
};

}  // namespace syncline::ui
