// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

/// First in main(): some memory is kept for the way down. The first allocation that fails gives it back, and fails all
/// the same (std::bad_alloc): what is unwound then, and the words that say so, find memory, for also destructors of
/// others allocate, where a failure would end the program. Once; without memory for it nothing is kept. Any thread.
void hold_memory_reserve() noexcept;

}  // namespace syncline
