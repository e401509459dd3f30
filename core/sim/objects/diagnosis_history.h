// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {
struct DiagnosisMessage;
}  // namespace syncline

namespace syncline::sim {

class ObjectDictionary;

/// Diagnosis history 0x10F3 of a device (ETG.1020, 16): a ring of messages in the object dictionary, in overwrite
/// or acknowledge mode as the master chooses by 0x10F3:05.
class DiagnosisHistory {
 public:
  static constexpr std::uint8_t kMessages = 8;

  explicit DiagnosisHistory(ObjectDictionary& dictionary);
  /// Adds the object; without it add() does nothing.
  void enable();
  void add(const DiagnosisMessage& message);

 private:
  /// Sub-index behind `sub_index` in the ring.
  [[nodiscard]] static std::uint8_t behind(std::uint8_t sub_index);
  void clear();
  /// 0: forgets all. Else the message of that sub-index and all before it; an abort code when there is none.
  std::uint32_t acknowledge(std::uint8_t sub_index);
  [[nodiscard]] std::uint16_t flags();

  ObjectDictionary& dictionary_;
  bool enabled_ = false;
  unsigned unread_ = 0;  // messages behind the newest acknowledged one
};

}  // namespace syncline::sim
