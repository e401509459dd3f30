// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_end_cap.h"

#include "eni/xml/xml_number.h"

namespace syncline::eni {
namespace {

using Element = tinyxml2::XMLElement;

}  // namespace

bool is_end_cap(const Element& slave) {
  const Element* info = slave.FirstChildElement("Info");
  if (info == nullptr) return false;
  const Element* address = info->FirstChildElement("PhysAddr");
  const char* const text = address != nullptr ? address->GetText() : nullptr;
  if (text != nullptr && parse_number(text) != 0) return false;
  const Element* commands = slave.FirstChildElement("InitCmds");
  if (commands != nullptr && commands->FirstChildElement() != nullptr) return false;
  const Element* data = slave.FirstChildElement("ProcessData");
  if (data != nullptr && data->FirstChildElement() != nullptr) return false;
  return slave.FirstChildElement("Mailbox") == nullptr && slave.FirstChildElement("HotConnect") == nullptr;
}

}  // namespace syncline::eni
