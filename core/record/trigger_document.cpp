// SPDX-License-Identifier: Apache-2.0
#include "record/trigger_document.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace syncline {
namespace {

constexpr std::string_view kKind = "triggers";
using DocumentFields = std::map<std::string_view, std::string_view, std::less<>>;

/// Tabulators and ends of lines are no part of a field.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\\\";
    if (c == '\t') out += "\\t";
    if (c == '\n') out += "\\n";
    if (c != '\\' && c != '\t' && c != '\n') out += c;
  }
  return out;
}

std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
      continue;
    }
    const char next = text[++i];
    out += next == 't' ? '\t' : next == 'n' ? '\n' : next;
  }
  return out;
}

/// As a trigger says whose signal it is.
std::string_view owner_word(SignalInfo::Scope scope) {
  switch (scope) {
    case SignalInfo::Scope::kSlave:
      return "slave";
    case SignalInfo::Scope::kVariable:
      return "variable";
    case SignalInfo::Scope::kBus:
      break;
  }
  return "bus";
}

SignalInfo::Scope owner_of(std::string_view word) {
  for (const auto scope : {SignalInfo::Scope::kSlave, SignalInfo::Scope::kVariable}) {
    if (owner_word(scope) == word) return scope;
  }
  return SignalInfo::Scope::kBus;
}

void put_trigger(std::string& out, const Trigger& t) {
  const auto& signal = info(t.signal);
  fmt::format_to(std::back_inserter(out),
                 "trigger\tkind={}\tmode={}\tsignal={}\tscope={}\tslave={}\tvariable={}\tedge={}\tmagnitude={}\t"
                 "enters={}\tlevel={}\tlow={}\thigh={}\tcode={}\thold_off_ns={}\tpre_ns={}\tpost_ns={}\n",
                 static_cast<int>(t.kind), static_cast<int>(t.mode), signal.key, owner_word(signal.scope), t.slave,
                 escaped(t.variable), static_cast<int>(t.edge), t.magnitude ? 1 : 0, t.enters ? 1 : 0, t.level, t.low,
                 t.high, escaped(t.code), t.hold_off, t.pre, t.post);
}

void put_episode(std::string& out, const TriggerEpisode& e, std::string_view name) {
  fmt::format_to(std::back_inserter(out), "episode\ttime_ns={}\tcycle={}\tslave={}\tvalue={}\tfrom_ns={}\tto_ns={}\t",
                 e.time, e.cycle ? fmt::format("{}", *e.cycle) : "", e.slave, e.value, e.from, e.to);
  fmt::format_to(std::back_inserter(out), "left_out={}\tname={}\n", e.left_out, escaped(name));
}

/// The first field, and the others by their names.
std::string_view split(std::string_view line, DocumentFields& fields) {
  fields.clear();
  const auto next = [&line] {
    const auto end = line.find('\t');
    const auto field = line.substr(0, end);
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
    return field;
  };
  const auto what = next();
  while (!line.empty()) {
    const auto field = next();
    const auto is = field.find('=');
    if (is != std::string_view::npos) fields[field.substr(0, is)] = field.substr(is + 1);
  }
  return what;
}

/// Takes a line apart; what is missing or no number makes it none.
class DocumentLine {
 public:
  explicit DocumentLine(const DocumentFields& fields) : fields_(fields) {}

  template <class T>
  void number(std::string_view name, T& out) {
    const auto text = field(name);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    good_ = good_ && error == std::errc{} && end == text.data() + text.size();
  }
  template <class E>
  void choice(std::string_view name, E& out, int most) {
    int value = -1;
    number(name, value);
    good_ = good_ && value >= 0 && value <= most;
    if (good_) out = static_cast<E>(value);
  }
  void yes(std::string_view name, bool& out) { choice(name, out, 1); }
  void text(std::string_view name, std::string& out) { out = unescaped(field(name)); }
  [[nodiscard]] std::string_view field(std::string_view name) {
    const auto found = fields_.find(name);
    good_ = good_ && found != fields_.end();
    return found == fields_.end() ? std::string_view{} : found->second;
  }
  void refuse() { good_ = false; }
  [[nodiscard]] bool good() const { return good_; }

 private:
  const DocumentFields& fields_;
  bool good_ = true;
};

std::optional<Trigger> read_trigger(const DocumentFields& fields) {
  DocumentLine line(fields);
  Trigger t;
  line.choice("kind", t.kind, static_cast<int>(Trigger::Kind::kFinding));
  line.choice("mode", t.mode, static_cast<int>(Trigger::Mode::kSingle));
  line.choice("edge", t.edge, static_cast<int>(Trigger::Edge::kEither));
  const auto* signal = find_signal(line.field("signal"), owner_of(line.field("scope")));
  if (signal == nullptr || signal->form == SignalInfo::Form::kCell) {
    line.refuse();
  } else {
    t.signal = signal->id;
  }
  line.number("slave", t.slave);
  line.text("variable", t.variable);
  line.yes("magnitude", t.magnitude);
  line.yes("enters", t.enters);
  line.number("level", t.level);
  line.number("low", t.low);
  line.number("high", t.high);
  line.text("code", t.code);
  line.number("hold_off_ns", t.hold_off);
  line.number("pre_ns", t.pre);
  line.number("post_ns", t.post);
  return line.good() ? std::optional(t) : std::nullopt;
}

void read_episode(const DocumentFields& fields, KeptTrigger& kept) {
  DocumentLine line(fields);
  TriggerEpisode e;
  line.number("time_ns", e.time);
  if (!line.field("cycle").empty()) line.number("cycle", e.cycle.emplace());
  line.number("slave", e.slave);
  line.number("value", e.value);
  line.number("from_ns", e.from);
  line.number("to_ns", e.to);
  line.number("left_out", e.left_out);
  std::string name;
  line.text("name", name);
  if (!line.good() || kept.episodes.size() >= TriggerWatch::kMostEpisodes) return;
  kept.episodes.push_back(e);
  if (!name.empty()) kept.names[e.time] = std::move(name);
}

}  // namespace

RecordedDocument trigger_document(std::span<const KeptTrigger> kept) {
  std::string body;
  for (const auto& one : kept) {
    put_trigger(body, one.trigger);
    for (const auto& episode : one.episodes) {
      const auto name = one.names.find(episode.time);
      put_episode(body, episode, name == one.names.end() ? std::string_view{} : name->second);
    }
  }
  return {std::string(kKind), "triggers.txt", std::move(body)};
}

std::vector<KeptTrigger> kept_triggers(const RecordingAbout& about) {
  std::vector<KeptTrigger> kept;
  DocumentFields fields;
  bool known = false;
  for (const auto& document : about.documents) {
    if (document.kind != kKind) continue;
    for (auto rest = std::string_view(document.body); !rest.empty();) {
      const auto end = rest.find('\n');
      const auto what = split(rest.substr(0, end), fields);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      if (what == "trigger") {
        const auto trigger = read_trigger(fields);
        known = trigger.has_value();
        if (known) kept.push_back({*trigger, {}});
      } else if (what == "episode" && known) {
        read_episode(fields, kept.back());
      }
    }
  }
  return kept;
}

}  // namespace syncline
