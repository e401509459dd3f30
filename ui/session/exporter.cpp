// SPDX-License-Identifier: Apache-2.0
#include "ui/session/exporter.h"

#include <QDir>
#include <QFileInfo>

#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "eni/report/reported_eni.h"
#include "ui/files/held_file.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

Result<std::vector<Finding>> exportEni(Workspace& workspace, const QString& path) {
  // Two files, of which nobody else has the second in view.
  const bool reported = workspace.eni().reported();
  for (const auto& file : {path, reported ? reportFile(path) : path}) {
    if (auto status = mayWrite(file); !status) return tl::unexpected(status.error());
  }
  const auto dialect = workspace.eni().dialect();
  const auto compiled = dialect == EniDialect::kEcEngineer ? workspace.configuration().current()
                                                           : compile(workspace.document().project(), {dialect});
  if (!compiled) return tl::unexpected(compiled.error());
  const eni::ReportedEni what{
      .config = compiled->config,
      .dialect = dialect,
      .source = &workspace.document().project(),
      .name = workspace.document().displayName().toStdString(),
      .program = QStringLiteral("Syncline %1").arg(workspace.environment().version).toStdString(),
      .date = eni::report_date(),
      .findings = compiled->findings};
  const auto status = reported ? eni::save_reported_eni(what, path.toStdString(), reportFile(path).toStdString())
                               : eni::save_eni(compiled->config, path.toStdString(), eni::style_of(dialect));
  if (!status) return tl::unexpected(status.error());
  workspace.eni().noteExport();
  // The preview has checked the same text already, where nobody has edited since.
  const auto& preview = workspace.eni();
  if (preview.isCurrent() && preview.check() != nullptr && preview.view()->dialect == dialect)
    return eni::errors_of_export(*preview.check());
  return eni::errors_of_export(eni::write_eni(compiled->config, eni::style_of(dialect)));
}

QString reportFile(const QString& path) {
  const QFileInfo file(path);
  auto name = file.completeBaseName();
  if (name.endsWith(QStringLiteral(".eni"), Qt::CaseInsensitive)) name.chop(4);
  return QDir(file.path()).filePath(name + QStringLiteral(".report.html"));
}

}  // namespace syncline::ui
