// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <map>
#include <memory>
#include <vector>

#include "support/result.h"

class QLockFile;

namespace syncline::ui {

struct LostWork;

class ProjectDocument;

/// Keeps unsaved edits on the disk, at most a second behind, in a file of this window's own, and finds what windows
/// that are gone have left. Files are written beside the window's thread. Without a folder it does nothing.
class Autosave final : public QObject {
  Q_OBJECT

 public:
  Autosave(ProjectDocument& document, QString folder, QObject* parent = nullptr);
  /// Unsaved work stays for the next start.
  ~Autosave() override;

  /// Newest first. Each belongs to this window until it is taken, discarded or left.
  [[nodiscard]] std::vector<LostWork> lost();
  /// In place of the present project, as unsaved.
  Status recover(const LostWork& lost);
  void discard(const LostWork& lost);
  /// For the next start.
  void leaveAll();
  /// The user wants it so: what is unsaved now is not kept.
  void forget();
  /// Writes what waits, and waits for it.
  void flush();

 Q_SIGNALS:
  /// What is unsaved cannot be kept (once until it can again).
  void failed(const syncline::Error& error);

 private:
  void onEdit();
  void keep();
  void done(const Status& status);
  bool lockOwn();

  ProjectDocument& document_;
  QString folder_, file_;
  std::unique_ptr<QLockFile> own_;
  std::map<QString, std::unique_ptr<QLockFile>> found_;  // of windows that are gone
  QTimer timer_;
  QThreadPool writer_;
  bool kept_ = false, told_ = false, forgotten_ = false;
};

}  // namespace syncline::ui
