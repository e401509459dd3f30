// SPDX-License-Identifier: Apache-2.0
#include "fuzz/command_target.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/cli/cli.h"
#include "app/cli/duration.h"
#include "compile/compile.h"
#include "eni/esi/esi_writer.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "fuzz/sandbox.h"
#include "tests/support/sample_devices.h"

namespace syncline::fuzz {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view kCommandMachine =
    "[[slave]]\nesi = \"esi/out.xml\"\ndc = \"none\"\n[[slave]]\nesi = \"esi/servo.xml\"\n";
constexpr const char* kLink = "sim:m.toml?virtual";

/// The files that the words name, in a folder that the program stands in.
class CommandSandbox {
 public:
  CommandSandbox() {
    std::filesystem::current_path(box_.path());
    for (const char* name : {"XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "HOME"})
      ::setenv(name, box_.path().c_str(), 1);
    Project project;
    for (const auto& device : {sample::digital_output(), sample::servo()}) {
      project.slaves.push_back(default_slave(device, static_cast<std::uint16_t>(project.slaves.size())));
      project.slaves.back().dc.op_mode = "";
    }
    project_ = eni::write_project(project);
    const auto compiled = compile(project);
    eni_ = compiled ? eni::write_eni(compiled->config) : "";
    esis_ = {eni::write_esi(sample::digital_output()), eni::write_esi(sample::servo())};
  }
  void fill() const {
    box_.clear();
    box_.put("m.toml", kCommandMachine);
    box_.put("p.syncline", project_);
    box_.put("e.xml", eni_);
    box_.put("esi/out.xml", esis_[0]);
    box_.put("esi/servo.xml", esis_[1]);
  }

 private:
  Sandbox box_;
  std::string project_, eni_;
  std::array<std::string, 2> esis_;
};

Words words_of(std::string_view text) {
  Words words;
  while (!text.empty()) {
    const auto end = text.find('\n');
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return words;
}

/// Nothing outside of the folder, no adapter of this machine, no real time, and no long time.
bool harmless(const Words& words) {
  constexpr std::size_t kMostWords = 24;
  constexpr Nanoseconds kLongest = 200 * kMillisecond;
  if (words.size() > kMostWords) return false;
  const bool runs = std::ranges::find(words, "run") != words.end();
  bool is_short = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto& word = words[i];
    if (word.find('\0') != std::string::npos || word.find("..") != std::string::npos) return false;
    if (word.find('/') != std::string::npos && !word.starts_with("esi/")) return false;
    if (word.find("nic:") != std::string::npos || word == "adapters" || word == "simulate") return false;
    if (word.find("sim:") != std::string::npos && word.find("?virtual") == std::string::npos) return false;
    if (word.starts_with("--for") && i + 1 < words.size()) {
      const auto duration = cli::parse_duration(words[i + 1]);
      is_short = duration && *duration <= kLongest;
    }
  }
  return !runs || is_short;
}

std::string_view some_word(Random& random) {
  static constexpr std::array<std::string_view, 88> kWords{"scan",
                                                           "sii",
                                                           "read",
                                                           "write",
                                                           "alias",
                                                           "sdo",
                                                           "list",
                                                           "foe",
                                                           "state",
                                                           "history",
                                                           "sync",
                                                           "dc",
                                                           "status",
                                                           "delays",
                                                           "project",
                                                           "create",
                                                           "show",
                                                           "set",
                                                           "keys",
                                                           "esi",
                                                           "index",
                                                           "match",
                                                           "search",
                                                           "try",
                                                           "export",
                                                           "check",
                                                           "compare",
                                                           "run",
                                                           "finish",
                                                           "--json",
                                                           "--help",
                                                           "--version",
                                                           "--link",
                                                           "sim:m.toml?virtual",
                                                           "sim:m.toml?virtual&seed=3",
                                                           "sim:e.xml?virtual",
                                                           "sim:p.syncline?virtual",
                                                           "replay:m.toml",
                                                           "--for",
                                                           "1ms",
                                                           "200ms",
                                                           "--state",
                                                           "PREOP",
                                                           "OP",
                                                           "INIT",
                                                           "BOOT",
                                                           "--csv",
                                                           "out.csv",
                                                           "--dcm-log",
                                                           "--capture",
                                                           "out.pcapng",
                                                           "--every-event",
                                                           "--set",
                                                           "p.syncline",
                                                           "e.xml",
                                                           "m.toml",
                                                           "esi",
                                                           "esi/servo.xml",
                                                           "--esi",
                                                           "--scan",
                                                           "--device",
                                                           "0x5EC:0x402",
                                                           "0x5EC:0x402:0x10002",
                                                           "--eni",
                                                           "--cycle",
                                                           "1000",
                                                           "--shift",
                                                           "bus",
                                                           "master",
                                                           "--sync-window",
                                                           "on",
                                                           "--op-mode",
                                                           "0=DC",
                                                           "1",
                                                           "0x1018:01",
                                                           "0x1000",
                                                           "--type",
                                                           "UINT",
                                                           "BYTES",
                                                           "-o",
                                                           "out.xml",
                                                           "--format",
                                                           "--dialect",
                                                           "twincat",
                                                           "--rounds",
                                                           "--cache",
                                                           "cache.sqlite",
                                                           "--complete"};
  return random.next() % 6 == 0 ? nasty_value(random) : kWords[pick(random, kWords.size())];
}

}  // namespace

void run_command(std::span<const std::uint8_t> bytes) {
  static const CommandSandbox sandbox;
  const auto words = words_of(text_of(bytes));
  if (!harmless(words)) return;
  sandbox.fill();
  std::ostringstream out, err;
  const int code = cli::run(words, {out, err});
  promise(code >= cli::kDone && code <= cli::kFailed);
  if (code != cli::kDone && code != cli::kAnswerIsNo) promise(!err.str().empty());
  const auto is = [](const char* name) { return [name](const std::string& word) { return word == name; }; };
  const bool json = std::ranges::any_of(words, is("--json"));
  const bool asks_for_help = std::ranges::any_of(words, [](const std::string& word) {
    return word.starts_with("-h") || word.starts_with("--h") || word.starts_with("--v");
  });
  if (json && !asks_for_help) promise(nlohmann::json::accept(out.str()));
}

std::vector<Bytes> commands() {
  const auto lines = [](const Words& words) {
    Bytes text;
    for (const auto& word : words) {
      text.insert(text.end(), word.begin(), word.end());
      text.push_back('\n');
    }
    return text;
  };
  return {lines({"scan", kLink, "--json"}),
          lines({"run", "p.syncline", "--link", kLink, "--for", "100ms", "--state", "PREOP", "--json"}),
          lines({"sdo", "read", kLink, "1", "0x1018:01"}),
          lines({"sii", "read", kLink, "0", "out.bin"}),
          lines({"project", "create", "new.syncline", "--scan", kLink, "--esi", "esi"}),
          lines({"project", "set", "p.syncline", "master.cycle_time_us=2000", "slave.1.name=Axis"}),
          lines({"export", "p.syncline", "-o", "out.xml", "--format", "eni"}),
          lines({"compare", "p.syncline", "e.xml", "--json"}),
          lines({"check", "e.xml", "--json"}),
          lines({"esi", "search", "servo", "--esi", "esi"}),
          lines({"dc", "status", kLink, "--project", "p.syncline"})};
}

Bytes damage_words(const Bytes& good, Random& random) {
  auto words = words_of(text_of(good));
  for (auto changes = random.next() % 3 + 1; changes > 0; --changes) {
    const auto place = pick(random, words.size());
    const auto at = words.begin() + static_cast<std::ptrdiff_t>(place);
    switch (words.empty() ? 3 : random.next() % 6) {
      case 0:
        *at = some_word(random);
        break;
      case 1:
        words.erase(at);
        break;
      case 2:
        words.insert(at, std::string(words[place]));
        break;
      case 3:
        words.insert(at, std::string(some_word(random)));
        break;
      case 4:
        if (const auto sign = at->find('='); sign != std::string::npos)
          at->replace(sign + 1, std::string::npos, some_word(random));
        break;
      default:
        if (!at->empty()) (*at)[pick(random, at->size())] = static_cast<char>(random.next());
    }
  }
  Bytes text;
  for (const auto& word : words) {
    text.insert(text.end(), word.begin(), word.end());
    text.push_back('\n');
  }
  return text;
}

}  // namespace syncline::fuzz
