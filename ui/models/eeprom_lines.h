// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>
#include <span>

#include "ui/models/record_model.h"

namespace syncline::sii {
struct Image;
}  // namespace syncline::sii

namespace syncline::ui {

/// What an EEPROM says, in lines of a part and its value: configuration, identity, mailboxes, each category.
[[nodiscard]] RecordModel::Lines eepromLines(const sii::Image& image);
/// Sixteen bytes a line with their word address and what is text of them.
[[nodiscard]] QString hexView(std::span<const std::uint8_t> bytes);

}  // namespace syncline::ui
