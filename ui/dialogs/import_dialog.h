// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "record/import_run.h"

class QDoubleSpinBox;
class QSpinBox;

namespace syncline::ui {

/// How much of a capture becomes a recording, and what its readings are held against. As it opens it takes all.
class ImportDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit ImportDialog(const QString& capture, QWidget* parent = nullptr);
  [[nodiscard]] ImportLimits limits() const;

 private:
  void keepInOrder();

  QDoubleSpinBox *from_, *until_, *deviation_, *error_;
  QSpinBox* frames_;
};

}  // namespace syncline::ui
