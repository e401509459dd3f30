// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <functional>

namespace syncline::exports {
struct Format;
}  // namespace syncline::exports

namespace syncline::ui {

class FileCommands;
class Workspace;

/// What is made of the project beside its ENI: tables, a header for C, a drawing; an entry a format of core/exports.
class ExportMenu final : public QMenu {
  Q_OBJECT

 public:
  /// `commit`: hands in what is being typed; false: a field holds what cannot be a value.
  ExportMenu(Workspace& workspace, const FileCommands& files, QWidget& window, std::function<bool()> commit);

  /// Complete or not at all, which is told; false: not.
  bool write(const exports::Format& format, const QString& path);

 private:
  void ask(const exports::Format& format, const QString& title);

  Workspace& workspace_;
  const FileCommands& files_;
  QWidget& window_;
  std::function<bool()> commit_;
};

}  // namespace syncline::ui
