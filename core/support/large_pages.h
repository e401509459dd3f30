// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace syncline {

/// Memory that is going to be filled from one end to the other: taken from the system in large pages (2 MiB) as it is
/// touched, where the system has them for who asks (transparent_hugepage: madvise). Filling a gigabyte takes half the
/// time then. What is in the memory stays; what is shorter than such a page is left alone. Any thread.
void use_large_pages(void* begin, std::size_t bytes);

/// Room for `count` in such memory, before anything lies in it; what is there already is moved over.
template <class T>
void reserve_in_large_pages(std::vector<T>& values, std::size_t count) {
  if (count <= values.capacity()) return;
  std::vector<T> larger;
  larger.reserve(count);
  use_large_pages(larger.data(), larger.capacity() * sizeof(T));
  larger.assign(values.begin(), values.end());
  values.swap(larger);
}

}  // namespace syncline
