// SPDX-License-Identifier: Apache-2.0
#include "ui/text/menu_key.h"

#include <QRegularExpression>

namespace syncline::ui {

QString withoutMenuKey(QString text) {
  static const QRegularExpression behind(QStringLiteral("\\(&.\\)"));
  return text.remove(behind).remove(u'&');
}

}  // namespace syncline::ui
