// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "ui/session/template_store.h"

class QWidget;

namespace syncline::ui {

class FileCommands;
class Workspace;

/// Keeps the project as a template, and begins with one.
class TemplateCommands final : public QObject {
  Q_OBJECT

 public:
  TemplateCommands(Workspace& workspace, FileCommands& files, QWidget& window);

  /// Asks for a name.
  void save();
  /// Asks before it replaces one; false: nothing was kept.
  bool saveAs(const QString& name);
  /// A new project as the template has it, without a file; false: all is as it was. What cannot be read is told.
  bool begin(const TemplateStore::Entry& entry);
  void remove(const TemplateStore::Entry& entry);

 private:
  Workspace& workspace_;
  FileCommands& files_;
  QWidget& window_;
};

/// Asks first; for every list of templates.
void removeTemplate(QWidget& window, TemplateStore& store, const TemplateStore::Entry& entry);

}  // namespace syncline::ui
