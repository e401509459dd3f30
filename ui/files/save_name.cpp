// SPDX-License-Identifier: Apache-2.0
#include "ui/files/save_name.h"

#include <QMessageBox>

#include "ui/files/held_file.h"
#include "ui/text/error_text.h"

namespace syncline::ui {

QString askSaveName(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                    QFileDialog::Options options) {
  const auto path = QFileDialog::getSaveFileName(parent, title, proposed, filter, nullptr, options);
  return path.isEmpty() || mayWriteOrTell(parent, title, path) ? path : QString();
}

bool mayWriteOrTell(QWidget* parent, const QString& title, const QString& path) {
  const auto status = mayWrite(path);
  if (!status) QMessageBox::warning(parent, title, errorText(status.error()));
  return status.has_value();
}

}  // namespace syncline::ui
