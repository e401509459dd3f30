// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/about_dialog.h"

#include <qwt_global.h>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QVBoxLayout>

namespace syncline::ui {

AboutDialog::AboutDialog(const QString& version, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("aboutDialog"));
  setWindowTitle(tr("About Syncline"));
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  auto* top = new QHBoxLayout;
  top->setSpacing(16);
  auto* mark = new QLabel;
  mark->setPixmap(QIcon(QStringLiteral(":/icons/syncline.svg")).pixmap(64, 64));
  top->addWidget(mark, 0, Qt::AlignTop);
  auto* text = new QLabel(tr("<h3>Syncline %1</h3><p>EtherCAT configurator and live synchronisation monitor.</p>"
                             "<p>Apache License 2.0. Built with Qt %2 (LGPL) and Qwt %3 (Qwt License).</p>")
                              .arg(version, QLatin1String(qVersion()), QStringLiteral(QWT_VERSION_STR)));
  text->setWordWrap(true);
  text->setMinimumWidth(380);
  top->addWidget(text, 1);
  layout->addLayout(top);
  auto* trademark =
      new QLabel(tr("EtherCAT is a registered trademark and patented technology, licensed by Beckhoff "
                    "Automation GmbH, Germany."));
  trademark->setObjectName(QStringLiteral("trademarkNote"));
  trademark->setWordWrap(true);
  trademark->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(trademark);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
}

}  // namespace syncline::ui
