// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <span>

#include "sim/objects/object_dictionary.h"
#include "support/byte_order.h"

namespace syncline::sim {

/// An entry that a device reads or writes in each of its cycles: found once, because the dictionary keeps its
/// entries where they are.
template <std::unsigned_integral T>
class ObjectValue {
 public:
  ObjectValue() = default;
  /// The entry must be at least as wide as T and must not be removed.
  explicit ObjectValue(ObjectDictionary::Entry& entry) : entry_(&entry) {}

  [[nodiscard]] T get() const { return load_le<T>(entry_->value); }
  void set(T value) { store_le<T>(std::span(entry_->value).first(sizeof(T)), value); }

 private:
  ObjectDictionary::Entry* entry_ = nullptr;
};

}  // namespace syncline::sim
