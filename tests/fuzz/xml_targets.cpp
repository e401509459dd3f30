// SPDX-License-Identifier: Apache-2.0
#include "fuzz/xml_targets.h"

#include <algorithm>

#include "compile/compile.h"
#include "eni/catalogue/esi_cards.h"
#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_writer.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "tests/support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline::fuzz {
namespace {

constexpr const char* kName = "fuzz.xml";

/// The errors of a file name it.
void promise_place(const Error& error) { promise(error.file == kName); }

template <class List>
void shorten(List& list) {
  list.resize(std::min<std::size_t>(list.size(), 1));
}

/// One command, PDO and variable of each kind.
NetworkConfig short_config(const DeviceDescription& device) {
  Project project;
  project.slaves.push_back(default_slave(device, 0));
  auto config = compile(project)->config;
  shorten(config.master.init_cmds);
  for (auto& slave : config.slaves) {
    shorten(slave.init_cmds);
    shorten(slave.pdos);
    for (auto& configured : slave.pdos) shorten(configured.pdo.entries);
    if (slave.mailbox) shorten(slave.mailbox->coe_commands);
    if (slave.mailbox) shorten(slave.mailbox->profiles);
  }
  shorten(config.image.inputs);
  shorten(config.image.outputs);
  return config;
}

/// With nothing between the elements.
Bytes short_eni(const NetworkConfig& config) {
  std::string text;
  for (const char c : eni::write_eni(config)) {
    if (c == ' ' && (text.empty() || text.back() == '>')) continue;
    if (c != '\n') text += c;
  }
  return bytes_of_text(text);
}

void configure(const DeviceDescription& device) {
  Project project;
  project.slaves.push_back(default_slave(device, 0));
  const auto compiled = compile(project);
  if (!compiled) return;
  const auto eni = eni::parse_eni(eni::write_eni(compiled->config), kName);
  promise(eni.has_value());
}

}  // namespace

void run_esi(std::span<const std::uint8_t> bytes) {
  const auto cards = eni::read_cards(text_of(bytes), kName);
  if (!cards) promise_place(cards.error());
  const auto file = eni::parse_esi(text_of(bytes), kName);
  if (!file) return promise_place(file.error());
  constexpr std::size_t kSome = 4;
  for (std::size_t i = 0; i < std::min(kSome, file->devices.size()); ++i) {
    const auto& device = file->devices[i];
    const auto again = eni::parse_esi(eni::write_esi(device), kName);
    promise(again.has_value());
    configure(device);
  }
}

void run_eni(std::span<const std::uint8_t> bytes) {
  const auto config = eni::parse_eni(text_of(bytes), kName);
  if (!config) return promise_place(config.error());
  // Most of what breaks does so in reading; each eighth is written and read again.
  if (bytes.size() % 8 != 0) return;
  const auto again = eni::parse_eni(eni::write_eni(*config), kName);
  promise(again.has_value());
}

void run_project(std::span<const std::uint8_t> bytes) {
  const auto project = eni::parse_project(text_of(bytes), kName);
  if (!project) return promise_place(project.error());
  const auto text = eni::write_project(*project);
  const auto again = eni::parse_project(text, kName);
  promise(again.has_value());
  promise(eni::write_project(*again) == text);
  (void)compile(*project);
}

std::vector<Bytes> esis() {
  std::vector<Bytes> corpus;
  for (const auto& slave : sample::small_machine().slaves)
    corpus.push_back(bytes_of_text(eni::write_esi(slave.device)));
  corpus.push_back(bytes_of_text(eni::write_esi(test::RandomProject(7).device())));
  return corpus;
}

/// Short ones, of which more are tried: what a drive has beside a terminal stands in two files.
std::vector<Bytes> enis() {
  auto mailbox = short_config(sample::servo()), cycles = mailbox;
  mailbox.cyclic.clear();
  mailbox.image = {};
  mailbox.slaves.front().pdos.clear();
  cycles.slaves.front().mailbox.reset();
  cycles.slaves.front().init_cmds.clear();
  return {short_eni(short_config(sample::digital_output())), short_eni(mailbox), short_eni(cycles)};
}

std::vector<Bytes> projects() {
  return {bytes_of_text(eni::write_project(sample::small_machine())),
          bytes_of_text(eni::write_project(test::RandomProject(11).project()))};
}

}  // namespace syncline::fuzz
