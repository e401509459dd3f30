// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "config/mailbox_description.h"
#include "ui/pages/command_parts.h"

namespace syncline::ui {

/// As which data type the value of a start-up command is written, a code of CoE; kBytesType: bytes.
using ValueType = std::function<std::uint16_t(const StartupCommand&)>;

/// The parts of a CoE start-up command ("slave.N.startup.K") and of one of SoE ("slave.N.soe.K").
[[nodiscard]] std::vector<RecordPart> coeParts(const ValueType& type, const ShownDevice& device);
[[nodiscard]] std::vector<RecordPart> soeParts(const ShownDevice& device);

/// The type that the device's dictionary gives the object, else one of the size of the data.
[[nodiscard]] std::uint16_t usualType(const DeviceDescription& device, const StartupCommand& command);

}  // namespace syncline::ui
