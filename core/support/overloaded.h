// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

/// A function for each alternative of a variant, for std::visit: one that is missing does not compile.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace syncline
