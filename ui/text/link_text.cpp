// SPDX-License-Identifier: Apache-2.0
#include "ui/text/link_text.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace syncline::ui {

bool isAdapter(const QString& link) { return link.startsWith(QLatin1String("nic:")); }

QString linkName(const QString& link, const QString& demo_link) {
  const auto file = link.section(u'?', 0, 0);
  if (!demo_link.isEmpty() && file == demo_link.section(u'?', 0, 0)) {
    return QCoreApplication::translate("Link", "Demonstration machine (simulated)");
  }
  const auto target = file.section(u':', 1);
  if (link == kMachineItself) return QCoreApplication::translate("Link", "This machine (simulated)");
  if (isAdapter(file)) return QCoreApplication::translate("Link", "Network card %1").arg(target);
  if (file.startsWith(QLatin1String("sim:"))) {
    return QCoreApplication::translate("Link", "Simulated: %1").arg(QFileInfo(target).fileName());
  }
  return link;
}

}  // namespace syncline::ui
