// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace syncline {

/// Memory that is going to be filled from one end to the other: taken from the system in large pages (2 MiB) as it is
/// touched, where the system has them for who asks (transparent_hugepage: madvise). Filling a gigabyte takes half the
/// time then. What is in the memory stays; what is shorter than such a page is left alone. Any thread.
void use_large_pages(void* begin, std::size_t bytes);

}  // namespace syncline
