// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QLabel;

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

class Card;
class ChoiceEdit;
class Page;

/// What a device's synchronisation objects are set to at start-up, and what its family takes.
class SyncSettingsEditor final : public QObject {
  Q_OBJECT

 public:
  SyncSettingsEditor(Card& card, Page& page);
  void showSlave(const SlaveSettings& slave);

 private:
  void showLimit(const SlaveSettings& slave);

  ChoiceEdit *limit_, *type_;
  QLabel *family_, *cycles_;
};

}  // namespace syncline::ui
