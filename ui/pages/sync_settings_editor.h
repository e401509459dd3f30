// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "config/project.h"

class QComboBox;
class QLabel;

namespace syncline::ui {

class Card;

/// What a device's synchronisation objects are set to at start-up, and what its family takes.
class SyncSettingsEditor final : public QObject {
  Q_OBJECT

 public:
  SyncSettingsEditor(Card& card, QObject* parent);
  void show(const SlaveSettings& slave);

 Q_SIGNALS:
  /// A settings key below "slave.N." and its value.
  void edited(const QString& text, const QString& key, const QString& value);

 private:
  void showLimit(const SlaveSettings& slave);
  void showType(const SlaveSettings& slave);

  QComboBox *limit_, *type_;
  QLabel *family_, *cycles_;
};

}  // namespace syncline::ui
