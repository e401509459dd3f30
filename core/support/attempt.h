// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace syncline {

/// What a destructor does besides giving back: `work` as far as it goes. What it throws (there is no memory, not even
/// for the words of an error) ends it and is told to nobody: a destructor that throws ends the program. What must be
/// given back in any case (a thread, a file) is given back by `work` before it can throw, or by another destructor.
template <class Work>
void attempt(Work&& work) noexcept {
  try {
    (void)std::forward<Work>(work)();
  } catch (...) {
    return;
  }
}

}  // namespace syncline
