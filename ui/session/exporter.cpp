// SPDX-License-Identifier: Apache-2.0
#include "ui/session/exporter.h"

#include "eni/format/eni_file.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

Status exportEni(Workspace& workspace, const QString& path) {
  const auto dialect = workspace.eni().dialect();
  const auto compiled = dialect == EniDialect::kEcEngineer ? workspace.configuration().current()
                                                           : compile(workspace.document().project(), {dialect});
  if (!compiled) return tl::unexpected(compiled.error());
  if (auto status = eni::save_eni(compiled->config, path.toStdString(), eni::style_of(dialect)); !status) return status;
  workspace.eni().noteExport();
  return {};
}

}  // namespace syncline::ui
