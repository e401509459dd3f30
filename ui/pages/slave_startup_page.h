// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "ui/editors/page.h"

class QComboBox;
class QLabel;

namespace syncline {
struct MessageProtocol;
struct SlaveSettings;
struct Snapshot;
struct StartupCommand;
}  // namespace syncline

namespace syncline::settings {
struct Place;
struct Setting;
}  // namespace syncline::settings

namespace syncline::ui {

class RecordEditor;

/// The commands that a slave gets by its mailbox as it starts: objects of CoE, parameters of SoE, messages of the
/// other protocols.
class SlaveStartupPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveStartupPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void showPlace(const settings::Setting& setting, const settings::Place& place) override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 private:
  void addTypes();
  void showTypes();
  void chooseObject();
  [[nodiscard]] const SlaveSettings* slave() const;
  void showSent();
  [[nodiscard]] std::uint16_t typeOf(const StartupCommand& command) const;
  [[nodiscard]] std::optional<StartupCommand> selected() const;

  /// The list of one of the protocols that know only whole messages.
  struct Messages {
    RecordEditor* editor;
    const MessageProtocol* protocol;
    const char* key;
  };

  RecordEditor *coe_, *soe_;
  QLabel* sent_;
  std::vector<Messages> messages_;
  QComboBox* type_;
  QWidget* choose_;
  /// As what the user wants to see a value: slave, index and sub-index to a data type.
  std::map<std::tuple<int, std::uint16_t, std::uint8_t>, std::uint16_t> wanted_types_;
};

}  // namespace syncline::ui
