// SPDX-License-Identifier: Apache-2.0
#include "ui/files/save_name.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>

#include "ui/files/held_file.h"
#include "ui/text/error_text.h"

namespace syncline::ui {

QString askSaveName(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                    QFileDialog::Options options) {
  const auto path = QFileDialog::getSaveFileName(parent, title, proposed, filter, nullptr, options);
  return path.isEmpty() || mayWriteOrTell(parent, title, path) ? path : QString();
}

QString withSuffix(QWidget* parent, const QString& title, const QString& path, const QString& suffix) {
  if (path.isEmpty() || !QFileInfo(path).suffix().isEmpty()) return path;
  const auto complete = path + suffix;
  if (!QFileInfo::exists(complete)) return complete;
  QMessageBox box(
      QMessageBox::Warning, title,
      QCoreApplication::translate("SaveName", "%1 is there already. Replace it?").arg(QFileInfo(complete).fileName()),
      QMessageBox::Yes | QMessageBox::No, parent);
  box.setObjectName(QStringLiteral("replaceQuestion"));
  box.setDefaultButton(QMessageBox::No);
  return box.exec() == QMessageBox::Yes ? complete : QString();
}

bool mayWriteOrTell(QWidget* parent, const QString& title, const QString& path) {
  const auto status = mayWrite(path);
  if (!status) QMessageBox::warning(parent, title, errorText(status.error()));
  return status.has_value();
}

}  // namespace syncline::ui
