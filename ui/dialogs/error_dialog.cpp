// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/error_dialog.h"

#include <QMessageBox>

#include "support/result.h"
#include "ui/text/error_text.h"

namespace syncline::ui {

void showError(QWidget* parent, const QString& what, const Error& error) {
  auto* box = new QMessageBox(QMessageBox::Warning, QObject::tr("Syncline"), what, QMessageBox::Ok, parent);
  box->setObjectName(QStringLiteral("errorDialog"));
  box->setInformativeText(errorText(error));
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace syncline::ui
