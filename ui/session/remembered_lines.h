// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace syncline::ui {

class WindowMemory;

/// Lines that the window remembers of a project's file under a name of their own; of a project without a file none.
class RememberedLines {
 public:
  /// `group`: the name, for all projects.
  RememberedLines(WindowMemory& memory, QString group, QString path);

  /// Of this file from now on; false where it was before.
  bool setPath(const QString& path);
  [[nodiscard]] QStringList read() const;
  void write(const QStringList& lines);

 private:
  [[nodiscard]] QString place() const;

  WindowMemory& memory_;
  QString group_, path_;
};

}  // namespace syncline::ui
