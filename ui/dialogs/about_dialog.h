// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace syncline::ui {

class AboutDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(const QString& version, QWidget* parent = nullptr);
};

}  // namespace syncline::ui
