// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export_menu.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <utility>

#include "exports/formats.h"
#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/file_commands.h"
#include "ui/files/held_file.h"
#include "ui/files/save_name.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// Of each format, by its name in the table.
constexpr std::array<std::pair<std::string_view, const char*>, 6> kTitles{{
    {"c-header", QT_TRANSLATE_NOOP("ExportMenu", "&C Header of the Process Image…")},
    {"csv", QT_TRANSLATE_NOOP("ExportMenu", "&Process Image (CSV)…")},
    {"pdo-csv", QT_TRANSLATE_NOOP("ExportMenu", "P&DOs and Their Entries (CSV)…")},
    {"init-csv", QT_TRANSLATE_NOOP("ExportMenu", "&Init Commands (CSV)…")},
    {"slaves-csv", QT_TRANSLATE_NOOP("ExportMenu", "&Slaves (CSV)…")},
    {"svg", QT_TRANSLATE_NOOP("ExportMenu", "&Topology (SVG)…")},
}};

}  // namespace

ExportMenu::ExportMenu(Workspace& workspace, const FileCommands& files, QWidget& window, std::function<bool()> commit)
    : QMenu(tr("Export Ta&bles and Code"), &window),
      workspace_(workspace),
      files_(files),
      window_(window),
      commit_(std::move(commit)) {
  setObjectName(QStringLiteral("menuExport"));
  for (const auto& format : exports::formats()) {
    const auto title = std::ranges::find(kTitles, format.name, [](const auto& one) { return one.first; });
    const auto text =
        title == kTitles.end() ? fromView(format.what) : QCoreApplication::translate("ExportMenu", title->second);
    auto* action = addAction(text);
    action->setObjectName(QStringLiteral("export-") + fromView(format.name));
    connect(action, &QAction::triggered, this, [this, &format, text] { ask(format, text); });
  }
  const auto update = [this] {
    menuAction()->setEnabled(!workspace_.document().project().slaves.empty() && !workspace_.recording().isOpen());
  };
  connect(&workspace.document(), &ProjectDocument::projectChanged, this, update);
  connect(&workspace.recording(), &OpenedRecording::changed, this, update);
  update();
}

void ExportMenu::ask(const exports::Format& format, const QString& title) {
  if (!commit_()) return;
  const auto suffix = fromView(format.suffix);
  const auto name = QString(title).remove(u'&').remove(u'…');
  const auto path = QFileDialog::getSaveFileName(&window_, name, files_.proposedExport(suffix),
                                                 QStringLiteral("*.%1").arg(QFileInfo(suffix).suffix()));
  if (const auto complete = withSuffix(&window_, name, path, suffix); !complete.isEmpty()) write(format, complete);
}

bool ExportMenu::write(const exports::Format& format, const QString& path) {
  const auto& compiled = workspace_.configuration().current();
  auto status = compiled ? mayWrite(path) : Status(tl::unexpected(compiled.error()));
  if (status) {
    const auto stem = QFileInfo(path).completeBaseName().toStdString();
    status = write_whole_file(path.toStdString(), format.text(compiled->config, stem));
  }
  if (!status) {
    workspace_.report(status.error(), Severity::kError, tr("Export"));
    showError(&window_, tr("The file could not be written."), status.error());
    return false;
  }
  workspace_.inform(tr("Export"), tr("Written to %1").arg(path));
  return true;
}

}  // namespace syncline::ui
