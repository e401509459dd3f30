// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_file_name.h"

#include <QRegularExpression>

namespace syncline::ui {

QString runFileName(QString text) {
  static const QRegularExpression unfit(QStringLiteral("[\\x00-\\x1f/\\\\:*?\"<>|]"));
  text.replace(unfit, QStringLiteral("_"));
  constexpr qsizetype kLongest = 80;
  return text.left(kLongest);
}

}  // namespace syncline::ui
