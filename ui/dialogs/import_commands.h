// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace syncline {
struct RecoveredProject;
}

namespace syncline::ui {

class Workspace;

/// What other tools' files become here: an ENI a project, ESI files devices of the catalogue.
class ImportCommands final : public QObject {
  Q_OBJECT

 public:
  ImportCommands(Workspace& workspace, QWidget& window);

  /// A project of what the ENI lets be seen, in place of the present one when `may` says yes; asked only when the file
  /// could be read and the catalogue said, in its own thread, which devices it has of it.
  void importEni(const QString& path, const std::function<bool()>& may);
  /// Asks, then reads the folder of the file into the catalogue in the background.
  void addEsiFolder(const QString& path);

 private:
  void take(const QString& path, RecoveredProject recovered);

  Workspace& workspace_;
  QWidget& window_;
};

}  // namespace syncline::ui
