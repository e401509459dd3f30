// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

/// First in main(): of standard input, output and error those that are closed are taken, by something that cannot be
/// read or written. Else the first file that is opened has their number, and what is printed goes into it.
void take_closed_streams();

}  // namespace syncline
