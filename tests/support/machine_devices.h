// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/device_description.h"

/// Devices that most simulated machines of tests are made of.
namespace syncline::test {

/// A terminal with 4 bytes out and 4 in, distributed clocks, no mailbox.
[[nodiscard]] DeviceDescription io8();

/// A terminal whose process data fill most of a frame.
[[nodiscard]] DeviceDescription large_io();

/// A terminal that maps the time stamps of its external synchronisation.
[[nodiscard]] DeviceDescription bridge();

/// A servo drive with a CoE mailbox and start-up objects.
[[nodiscard]] DeviceDescription servo();

}  // namespace syncline::test
