// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

#include "ui/session/bus_connection.h"

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace syncline::ui {

/// Chooses the bus: the simulated demonstration machine, a scenario file, or a network card.
class LinkChooser final : public QDialog {
  Q_OBJECT

 public:
  LinkChooser(const Environment& environment, const QString& current, const QString& action, QWidget* parent = nullptr);
  [[nodiscard]] QString link() const;

 private:
  void addLink(const QString& link, const QString& title, const QString& detail, const QString& icon);
  void addAdapters(const AdapterLister& list_adapters);
  void browse();

  QListWidget* list_;
  QLabel* note_;
  QDialogButtonBox* buttons_;
};

}  // namespace syncline::ui
