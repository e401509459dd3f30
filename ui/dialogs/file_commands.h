// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace syncline::ui {

class Workspace;

/// New, open, save and export with their dialogs.
class FileCommands final : public QObject {
  Q_OBJECT

 public:
  FileCommands(Workspace& workspace, QWidget& window);

  void create();
  void open();
  /// Opens without asking for a name; errors are shown.
  bool openFile(const QString& path);
  bool save();
  bool saveAs();
  void exportEni();
  bool exportTo(const QString& path);
  /// Asks about unsaved changes; false = stay.
  bool mayDiscard();

 private:
  bool saveTo(const QString& path);
  [[nodiscard]] QString proposedName(const QString& suffix) const;

  Workspace& workspace_;
  QWidget& window_;
};

}  // namespace syncline::ui
