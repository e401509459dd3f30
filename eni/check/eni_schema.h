// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// What ETG.2100 allows in an ENI file, as far as the checker needs it: element order, counts and types.
namespace syncline::eni {

enum class EniValue : std::uint8_t {
  kChildren,  // elements, no text
  kAnything,  // not looked into
  kText,
  kInt,     // xs:int
  kUInt32,  // xs:int that holds 32 unsigned bits, negative from 0x80000000 on
  kUInt16,
  kByte,
  kHexDec,  // HexDecValue: decimal or #x...
  kBool,
  kBytes,  // xs:hexBinary
  kMac,    // of 6 bytes
  kTransition,
  kSoeTransition,
  kState,
  kPort,
  kProtocol,
  kSmType,
  kRequires,
  kPhysics,
};

struct EniType;

struct EniChild {
  const char* name;
  EniValue value = EniValue::kText;
  std::uint8_t order = 0;  // elements of a lower order come first; equal ones in any order
  std::uint8_t at_least = 0;
  std::uint8_t at_most = 1;       // 0 = any number
  const EniType* type = nullptr;  // of kChildren
};

struct EniAttribute {
  const char* name;
  EniValue value = EniValue::kText;
  bool required = false;
};

/// Two elements of which one at most may be there, or exactly one.
struct EniChoice {
  const char* one;
  const char* other;
  bool required = false;
};

struct EniType {
  std::span<const EniChild> children;
  std::span<const EniAttribute> attributes = {};
  std::span<const EniChoice> choices = {};
  [[nodiscard]] const EniChild* child(std::string_view name) const;
  [[nodiscard]] const EniAttribute* attribute(std::string_view name) const;
};

/// Type of the element EtherCATConfig.
[[nodiscard]] const EniType& eni_schema();

}  // namespace syncline::eni
