// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Words and pictures that an ESI file gives for people.
namespace syncline {

/// Text in one language; ESI's LcId is the Windows language code.
struct LocalizedText {
  int language = 1033;  // 1033 English (US), 1031 German ...
  std::string text{};
  bool operator==(const LocalizedText&) const = default;
};

/// Picture of 16 x 14 pixels; ESI gives one of the three.
struct EsiImage {
  std::string name{};                // Image16x14: one of the configurator's own pictures
  std::string file{};                // ImageFile16x14: BMP file, relative to the ESI file
  std::vector<std::uint8_t> data{};  // ImageData16x14: content of a BMP file
  [[nodiscard]] bool empty() const { return name.empty() && file.empty() && data.empty(); }
  bool operator==(const EsiImage&) const = default;
};

/// Groups/Group: devices that a catalogue shows together.
struct DeviceGroup {
  std::string type{};                  // what Device/GroupType refers to
  std::string name{};                  // in the reader's language
  std::vector<LocalizedText> names{};  // all languages, file order
  int sort_order = 0;
  std::string parent{};  // type of the group above, display only
  EsiImage image{};
  bool operator==(const DeviceGroup&) const = default;
};

}  // namespace syncline
