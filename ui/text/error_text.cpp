// SPDX-License-Identifier: Apache-2.0
#include "ui/text/error_text.h"

#include <QCoreApplication>

#include "protocol/error_text.h"

namespace syncline::ui {

QString errorText(const Error& error) {
  const std::string source(error_template(error.code));
  const auto translated = QCoreApplication::translate("Error", source.c_str());
  return QString::fromStdString(fill_error_template(translated.toStdString(), error));
}

}  // namespace syncline::ui
