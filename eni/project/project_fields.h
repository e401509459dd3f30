// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "config/dcm_settings.h"
#include "config/identity.h"
#include "config/monitor_view.h"
#include "config/slave_options.h"
#include "eni/esi/esi_device.h"
#include "eni/esi/esi_writer.h"
#include "eni/xml/xml_number.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_writer.h"
#include "reasons/because.h"

namespace syncline {
struct MasterSettings;
struct SlaveSettings;
}  // namespace syncline

/// The fields of the project file, named once: the same function writes and reads them.
namespace syncline::eni {

/// Puts fields into an element; attributes before children.
class FieldWriter {
 public:
  explicit FieldWriter(XmlWriter& xml) : xml_(xml) {}

  template <std::integral T>
  void attribute(const char* name, const T& value) {
    xml_.attribute(name, fmt::format("{:d}", value));
  }
  template <class T>
  void attribute(const char* name, const std::optional<T>& value) {
    if (value) attribute(name, *value);
  }
  void attribute(const char* name, const std::optional<RevisionCheck>& rule) {
    if (rule) xml_.attribute(name, revision_check_name(*rule));
  }
  void attribute(const char* name, const std::optional<SyncTypeChoice>& type) {
    if (type) xml_.attribute(name, sync_type_name(*type));
  }
  void attribute_if_set(const char* name, bool value) {
    if (value) attribute(name, value);
  }
  template <std::integral T>
  void attribute_unless_zero(const char* name, const T& value) {
    if (value != 0) attribute(name, value);
  }
  void attribute(const char* name, const DcmMode& mode) { xml_.attribute(name, dcm_mode_name(mode)); }
  void attribute(const char* name, const std::string& text) { xml_.attribute(name, text); }
  void attribute(const char* name, const ValueScale& scale) { xml_.attribute(name, value_scale_name(scale)); }
  void attribute(const char* name, const ViewSignal::Of& of) { xml_.attribute(name, view_signal_of_name(of)); }
  void attribute(const char* name, const std::optional<AxisLimits>& limits) {
    if (limits) xml_.attribute(name, fmt::format("{} {}", limits->low, limits->high));
  }
  void attribute(const char* name, const std::array<std::uint8_t, 6>& mac) { xml_.attribute(name, hex_bytes(mac)); }
  void optional_text(const char* name, const std::string& value) {
    if (!value.empty()) xml_.element(name, value);
  }
  void bytes(const char* name, const std::vector<std::uint8_t>& value) { xml_.element(name, hex_bytes(value)); }
  void transitions(const std::vector<Transition>& values) {
    for (const auto value : values) xml_.element("Transition", transition_name(value));
  }
  void text(const char* name, const std::string& value) { xml_.element(name, value); }
  void indices(const char* name, const std::vector<std::uint16_t>& values) {
    std::string text;
    for (const auto value : values) text += (text.empty() ? "" : " ") + hex_dec(value);
    xml_.element(name, text);
  }
  void pdos(const char* name, const std::vector<Pdo>& values) {
    xml_.open(name);
    for (const Pdo& pdo : values) write_pdo(xml_, "Pdo", pdo);
    xml_.close();
  }
  template <class T, class Fields>
  void child(const char* name, const T& value, Fields fields) {
    xml_.open(name);
    fields(*this, value);
    xml_.close();
  }
  template <class T, class Fields>
  void child(const char* name, const std::optional<T>& value, Fields fields) {
    if (value) child(name, *value, fields);
  }
  template <class T, class Fields>
  void list(const char* name, const char* item, const std::vector<T>& values, Fields fields) {
    xml_.open(name);
    for (const T& value : values) child(item, value, fields);
    xml_.close();
  }
  /// Left out where it says nothing, so that files of projects that do not use it stay as they were.
  template <class T, class Fields>
  void unless_default(const char* name, const T& value, Fields fields) {
    if (!(value == T{})) child(name, value, fields);
  }
  template <class T, class Fields>
  void optional_list(const char* name, const char* item, const std::vector<T>& values, Fields fields) {
    if (!values.empty()) list(name, item, values, fields);
  }
  void optional_bytes(const char* name, const std::vector<std::uint8_t>& value) {
    if (!value.empty()) bytes(name, value);
  }
  /// Left out where it is `usual`, which a reader takes where nothing is said.
  template <class T, class Fields>
  void list_unless(const char* name, const char* item, const std::vector<T>& values, const std::vector<T>& usual,
                   Fields fields) {
    if (values != usual) list(name, item, values, fields);
  }
  void init_cmd(const StartupCommand& command) { write_init_cmd_content(xml_, command); }

 private:
  XmlWriter& xml_;
};

/// Takes fields out of an element. What is absent keeps its default, so that files of older versions load.
class FieldReader {
 public:
  explicit FieldReader(Node node) : node_(node) {}

  void attribute(const char* name, bool& value) { value = node_.boolean(name).value_or(value); }
  void attribute_if_set(const char* name, bool& value) { attribute(name, value); }
  template <std::integral T>
  void attribute(const char* name, T& value) {
    value = node_.number<T>(name).value_or(value);
  }
  template <std::integral T>
  void attribute_unless_zero(const char* name, T& value) {
    attribute(name, value);
  }
  template <class T>
  void attribute(const char* name, std::optional<T>& value) {
    value = node_.number<T>(name);
  }
  void attribute(const char* name, std::optional<bool>& value) { value = node_.boolean(name); }
  void attribute(const char* name, std::optional<std::array<std::uint8_t, 6>>& mac) {
    if (node_.has(name)) attribute(name, mac.emplace());
  }
  void attribute(const char* name, std::optional<RevisionCheck>& rule) {
    if (!node_.has(name)) return;
    rule = revision_check_from_name(node_.attribute(name));
    if (!rule) bad(name, because("is no rule"));
  }
  void attribute(const char* name, std::optional<SyncTypeChoice>& type) {
    if (!node_.has(name)) return;
    type = sync_type_from_name(node_.attribute(name));
    if (!type) bad(name, because("is no synchronisation type"));
  }
  void optional_text(const char* name, std::string& value) { text(name, value); }
  void attribute(const char* name, DcmMode& mode) {
    if (!node_.has(name)) return;
    const auto known = dcm_mode_from_name(node_.attribute(name));
    if (!known) return bad(name, because("is no mode"));
    mode = *known;
  }
  void attribute(const char* name, std::string& text) { text = node_.attribute(name); }
  void attribute(const char* name, ValueScale& scale) {
    if (!node_.has(name)) return;
    const auto known = value_scale_from_name(node_.attribute(name));
    if (!known) return bad(name, because("is no scale"));
    scale = *known;
  }
  void attribute(const char* name, ViewSignal::Of& of) {
    if (!node_.has(name)) return;
    const auto known = view_signal_of_from_name(node_.attribute(name));
    if (!known) return bad(name, because("is nothing that has signals"));
    of = *known;
  }
  void attribute(const char* name, std::optional<AxisLimits>& limits) {
    if (!node_.has(name)) return;
    limits = axis_limits_from_text(node_.attribute(name));
    if (!limits) bad(name, because("is no pair of limits, the lower one first"));
  }
  void attribute(const char* name, std::array<std::uint8_t, 6>& mac) {
    if (!node_.has(name)) return;
    const auto bytes = parse_hex_bytes(node_.attribute(name));
    if (!bytes || bytes->size() != mac.size()) return bad(name, because("is no Ethernet address"));
    std::ranges::copy(*bytes, mac.begin());
  }
  void text(const char* name, std::string& value) {
    if (const Node found = node_.child(name)) value = found.text();
  }
  void indices(const char* name, std::vector<std::uint16_t>& values);
  void pdos(const char* name, std::vector<Pdo>& values) {
    for (const Node& pdo : node_.child(name).children("Pdo")) values.push_back(read_pdo(pdo));
  }
  template <class T, class Fields>
  void child(const char* name, T& value, Fields fields) {
    const Node found = node_.child(name);
    FieldReader reader(found);
    if (found) fields(reader, value);
  }
  template <class T, class Fields>
  void child(const char* name, std::optional<T>& value, Fields fields) {
    if (node_.child(name)) child(name, value.emplace(), fields);
  }
  template <class T, class Fields>
  void list(const char* name, const char* item, std::vector<T>& values, Fields fields) {
    for (const Node& found : node_.child(name).children(item)) {
      FieldReader reader(found);
      fields(reader, values.emplace_back());
    }
  }
  template <class T, class Fields>
  void unless_default(const char* name, T& value, Fields fields) {
    child(name, value, fields);
  }
  template <class T, class Fields>
  void optional_list(const char* name, const char* item, std::vector<T>& values, Fields fields) {
    list(name, item, values, fields);
  }
  void bytes(const char* name, std::vector<std::uint8_t>& value) {
    if (const Node found = node_.child(name)) value = found.bytes();
  }
  void optional_bytes(const char* name, std::vector<std::uint8_t>& value) { bytes(name, value); }
  template <class T, class Fields>
  void list_unless(const char* name, const char* item, std::vector<T>& values, const std::vector<T>& usual,
                   Fields fields) {
    values = usual;
    if (!node_.child(name)) return;
    values.clear();
    list(name, item, values, fields);
  }
  void transitions(std::vector<Transition>& values);
  void init_cmd(StartupCommand& command);

 private:
  void bad(const char* name, Reason problem) const {
    node_.fail(ErrorCode::kXmlBadValue,
               because("{attribute}=\"{text}\" {reason}", name, node_.attribute(name), std::move(problem)));
  }
  Node node_;
};

/// Master element.
void write_fields(FieldWriter& writer, const MasterSettings& master);
void read_fields(FieldReader& reader, MasterSettings& master);
/// Slave element without its device.
void write_fields(FieldWriter& writer, const SlaveSettings& slave);
void read_fields(FieldReader& reader, SlaveSettings& slave);

}  // namespace syncline::eni
