// SPDX-License-Identifier: Apache-2.0
#include "channels/slave_request.h"

#include <fmt/format.h>

#include "support/overloaded.h"

namespace syncline {
namespace {

std::string object_text(coe::ObjectAddress object) {
  return fmt::format("object 0x{:04X}:{:02X}", object.index, object.sub_index);
}

}  // namespace

std::uint16_t slave_of(const SlaveRequest& request) {
  return std::visit([](const auto& what) { return what.slave; }, request);
}

std::string subject_of(const SlaveRequest& request) {
  using namespace requests;
  return std::visit(
      Overloaded{[](const SdoRead& r) { return object_text(r.object); },
                 [](const SdoWrite& r) { return object_text(r.object); },
                 [](const ObjectListRead&) { return std::string("object list"); },
                 [](const ObjectRead& r) { return fmt::format("description of 0x{:04X}", r.index); },
                 [](const EntryRead& r) { return fmt::format("description of 0x{:04X}:{:02X}", r.index, r.sub_index); },
                 [](const RegisterRead& r) { return fmt::format("register 0x{:04X}", r.address); },
                 [](const RegisterWrite& r) { return fmt::format("register 0x{:04X}", r.address); },
                 [](const EepromRead& r) { return fmt::format("EEPROM word 0x{:04X}", r.word); },
                 [](const EepromWrite& r) { return fmt::format("EEPROM word 0x{:04X}", r.word); },
                 [](const FileRead& r) { return fmt::format("file \"{}\"", r.name); },
                 [](const FileWrite& r) { return fmt::format("file \"{}\"", r.name); },
                 [](const StateChange&) { return std::string(); },
                 [](const ErrorAcknowledge&) { return std::string(); }},
      request);
}

}  // namespace syncline
