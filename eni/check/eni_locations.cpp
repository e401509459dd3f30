// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_locations.h"

#include <fmt/format.h>

#include <initializer_list>

#include "eni/format/eni_end_cap.h"
#include "eni/xml/xml_pieces.h"
#include "findings/finding.h"

namespace syncline::eni {
namespace {

using Element = tinyxml2::XMLElement;

/// As many as have station addresses; what is found about later ones stands at the Config.
constexpr std::size_t kMostSlaves = 0xFFFF;

int line_or_none(const Element* element) { return element ? line_of(*element) : 0; }

/// The element at the end of a path of names, or null.
const Element* descend(const Element* element, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (element == nullptr) return nullptr;
    element = element->FirstChildElement(name);
  }
  return element;
}

void append_lines(std::vector<int>& out, const Element* parent, const char* name) {
  if (parent == nullptr) return;
  for (const auto* e = parent->FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    out.push_back(line_or_none(e));
  }
}

int line_or(const std::vector<int>& lines, std::size_t index, int otherwise) {
  return index < lines.size() ? lines[index] : otherwise;
}

}  // namespace

EniLocations::EniLocations(XmlPieces& pieces) : root_(fmt::format("/{}/Config", pieces.root()->Name())) {
  const Element& root = *pieces.root();
  const Element* config = root.FirstChildElement("Config");
  config_ = line_or_none(config ? config : &root);
  const Element* master = descend(config, {"Master"});
  master_.element = line_or_none(master);
  append_lines(master_.parts, descend(master, {"InitCmds"}), "InitCmd");
  std::size_t index = 0;
  for (const auto* e = descend(config, {"Slave"}); e != nullptr; e = e->NextSiblingElement("Slave")) {
    ++index;
    const Element* slave = pieces.whole(*e);
    if (slave == nullptr || is_end_cap(*slave)) continue;
    if (slaves_.size() == kMostSlaves) break;
    slaves_.push_back(read_slave(*slave));
    slaves_.back().index = index;
  }
  for (const auto* e = descend(config, {"Cyclic"}); e != nullptr; e = e->NextSiblingElement("Cyclic")) {
    Task& task = tasks_.emplace_back();
    task.line = line_or_none(e);
    for (const auto* f = descend(pieces.whole(*e), {"Frame"}); f != nullptr; f = f->NextSiblingElement("Frame")) {
      task.frames.push_back({line_or_none(f), {}});
      append_lines(task.frames.back().parts, f, "Cmd");
    }
  }
  const Element* image = descend(config, {"ProcessImage"});
  if (image != nullptr) image = pieces.whole(*image);
  image_ = line_or_none(image);
  inputs_.element = line_or_none(descend(image, {"Inputs"}));
  outputs_.element = line_or_none(descend(image, {"Outputs"}));
  append_lines(inputs_.parts, descend(image, {"Inputs"}), "Variable");
  append_lines(outputs_.parts, descend(image, {"Outputs"}), "Variable");
}

EniLocations::Slave EniLocations::read_slave(const Element& element) {
  Slave slave;
  slave.line = line_of(element);
  slave.mailbox = line_or_none(descend(&element, {"Mailbox"}));
  slave.hot_connect = line_or_none(descend(&element, {"HotConnect"}));
  slave.dc = line_or_none(descend(&element, {"DC"}));
  append_lines(slave.cmds, descend(&element, {"InitCmds"}), "InitCmd");
  append_lines(slave.coe_cmds, descend(&element, {"Mailbox", "CoE", "InitCmds"}), "InitCmd");
  const Element* data = descend(&element, {"ProcessData"});
  for (int number = 0; number < 16; ++number) {
    if (const Element* manager = descend(data, {fmt::format("Sm{}", number).c_str()})) {
      slave.managers.push_back(line_or_none(manager));
      slave.manager_numbers.push_back(number);
    }
  }
  append_lines(slave.pdos, data, "TxPdo");
  slave.tx_pdos = slave.pdos.size();
  append_lines(slave.pdos, data, "RxPdo");
  return slave;
}

EniLocation EniLocations::part(const std::string& path, const Lines& lines, std::size_t index) const {
  return {line_or(lines.parts, index, lines.element ? lines.element : config_), fmt::format("{}[{}]", path, index + 1)};
}

EniLocation EniLocations::locate(const ConfigPlace& place) const {
  switch (place.kind) {
    case PlaceKind::kConfig:
      return {config_, root_};
    case PlaceKind::kMaster:
      return {master_.element ? master_.element : config_, root_ + "/Master"};
    case PlaceKind::kMasterInitCmd:
      return part(root_ + "/Master/InitCmds/InitCmd", master_, place.first);
    case PlaceKind::kImage:
      return {image_ ? image_ : config_, root_ + "/ProcessImage"};
    case PlaceKind::kInput:
      return part(root_ + "/ProcessImage/Inputs/Variable", inputs_, place.first);
    case PlaceKind::kOutput:
      return part(root_ + "/ProcessImage/Outputs/Variable", outputs_, place.first);
    case PlaceKind::kTask:
    case PlaceKind::kFrame:
    case PlaceKind::kCyclicCmd:
      return locate_in_task(place);
    default:
      return locate_in_slave(place);
  }
}

EniLocation EniLocations::locate_in_task(const ConfigPlace& place) const {
  const std::string path = fmt::format("{}/Cyclic[{}]", root_, place.first + 1);
  if (place.first >= tasks_.size()) return {config_, path};
  const Task& task = tasks_[place.first];
  if (place.kind == PlaceKind::kTask || place.second >= task.frames.size()) return {task.line, path};
  const Lines& frame = task.frames[place.second];
  const std::string frame_path = fmt::format("{}/Frame[{}]", path, place.second + 1);
  return place.kind == PlaceKind::kFrame ? EniLocation{frame.element, frame_path}
                                         : part(frame_path + "/Cmd", frame, place.third);
}

EniLocation EniLocations::locate_in_slave(const ConfigPlace& place) const {
  if (place.first >= slaves_.size()) return {config_, fmt::format("{}/Slave[{}]", root_, place.first + 1)};
  const Slave& slave = slaves_[place.first];
  const std::string path = fmt::format("{}/Slave[{}]", root_, slave.index);
  const auto inner = [&](int line, const std::string& name) {
    return EniLocation{line ? line : slave.line, path + name};
  };
  const std::size_t i = place.second;
  switch (place.kind) {
    case PlaceKind::kSlaveInitCmd:
      return inner(line_or(slave.cmds, i, 0), fmt::format("/InitCmds/InitCmd[{}]", i + 1));
    case PlaceKind::kSyncManager:
      return inner(line_or(slave.managers, i, 0),
                   fmt::format("/ProcessData/Sm{}", line_or(slave.manager_numbers, i, 0)));
    case PlaceKind::kPdo:
      return inner(line_or(slave.pdos, i, 0), i < slave.tx_pdos
                                                  ? fmt::format("/ProcessData/TxPdo[{}]", i + 1)
                                                  : fmt::format("/ProcessData/RxPdo[{}]", i - slave.tx_pdos + 1));
    case PlaceKind::kMailbox:
      return inner(slave.mailbox, "/Mailbox");
    case PlaceKind::kCoeCmd:
      return inner(line_or(slave.coe_cmds, i, 0), fmt::format("/Mailbox/CoE/InitCmds/InitCmd[{}]", i + 1));
    case PlaceKind::kHotConnect:
      return inner(slave.hot_connect, "/HotConnect");
    case PlaceKind::kDc:
      return inner(slave.dc, "/DC");
    default:
      return {slave.line, path};
  }
}

}  // namespace syncline::eni
