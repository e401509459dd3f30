// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/error_dialog.h"

#include <QMessageBox>
#include <QPushButton>

#include "support/result.h"
#include "ui/text/error_text.h"

namespace syncline::ui {

namespace {

QMessageBox* boxOf(QWidget* parent, const QString& what, const Error& error) {
  auto* box = new QMessageBox(QMessageBox::Warning, QObject::tr("Syncline"), what, QMessageBox::NoButton, parent);
  box->setObjectName(QStringLiteral("errorDialog"));
  box->setInformativeText(errorText(error));
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  box->setAttribute(Qt::WA_DeleteOnClose);
  return box;
}

}  // namespace

void showError(QWidget* parent, const QString& what, const Error& error) {
  auto* box = boxOf(parent, what, error);
  box->setStandardButtons(QMessageBox::Ok);
  box->open();
}

void showError(QWidget* parent, const QString& what, const Error& error, const QString& way,
               const std::function<void()>& then) {
  auto* box = boxOf(parent, what, error);
  auto* on = box->addButton(way, QMessageBox::AcceptRole);
  on->setObjectName(QStringLiteral("errorWay"));
  box->addButton(QMessageBox::Close);
  box->setDefaultButton(QMessageBox::Close);
  QObject::connect(on, &QAbstractButton::clicked, parent, then, Qt::QueuedConnection);
  box->open();
}

}  // namespace syncline::ui
