// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/entry_ports.h"
#include "config/network_config.h"
#include "exports/exports.h"
#include "exports/markup_text.h"

namespace syncline::exports {
namespace {

constexpr int kMargin = 24, kIndent = 56, kBoxWidth = 400, kBoxHeight = 52, kRowHeight = 72, kTrunk = 28,
              kLegendHeight = 40;
constexpr int kFirstRow = kMargin + kRowHeight;

/// At most `most` characters; a UTF-8 character is never cut.
std::string shortened(const std::string& text, std::size_t most) {
  std::size_t characters = 0, end = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;
    if (++characters == most) end = i;
  }
  return characters <= most ? text : text.substr(0, end) + "\xE2\x80\xA6";
}

struct Node {
  std::vector<std::size_t> children;
  int column = 0;
  char port = 'B';
};

/// Frames visit the last branch of a slave last: it goes straight down, those before it are moved to the right.
class Tree {
 public:
  explicit Tree(const NetworkConfig& config) : nodes_(config.slaves.size()) {
    std::vector<std::optional<PreviousPort>> wiring;
    for (const auto& slave : config.slaves) wiring.push_back(slave.previous);
    const auto entries = entry_ports(wiring);
    std::vector<std::size_t> open;  // those whose column is known
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto& previous = wiring[i];
      // In front of the one that it hangs at only where that one's cables are swapped.
      const bool known =
          previous && previous->position < nodes_.size() && (previous->position < i || entries[previous->position]);
      nodes_[i].port = static_cast<char>('A' + (known ? previous->port & 3U : 1U));
      if (known) {
        nodes_[previous->position].children.push_back(i);
      } else if (i > 0 && !wiring[0]) {
        nodes_[i - 1].children.push_back(i);
      } else {
        open.push_back(i);
      }
    }
    while (!open.empty()) {
      const auto& node = nodes_[open.back()];
      open.pop_back();
      for (const std::size_t child : node.children) {
        nodes_[child].column = node.column + (child == node.children.back() ? 0 : 1);
        open.push_back(child);
      }
    }
  }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] int columns() const {
    int most = 0;
    for (const auto& node : nodes_) most = std::max(most, node.column);
    return most + 1;
  }

 private:
  std::vector<Node> nodes_;
};

int left(const Node& node) { return kMargin + node.column * kIndent; }
int top(std::size_t row) { return kFirstRow + static_cast<int>(row) * kRowHeight; }

std::string line(int x1, int y1, int x2, int y2) {
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", x1, y1, x2, y2);
}

std::string label(int x, int y, const char* kind, std::string_view text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">{}</text>\n", x, y, kind, markup_text(text));
}

std::string cables(const Tree& tree) {
  std::string out = "<g class=\"cable\">\n" + line(kMargin + kTrunk, kMargin + kBoxHeight, kMargin + kTrunk, top(0));
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    const Node& parent = tree.nodes()[i];
    const int x = left(parent) + kTrunk;
    for (const std::size_t child : parent.children) {
      const bool straight = child == parent.children.back();
      const int y = straight ? top(child) : top(child) + kBoxHeight / 2;
      out += line(x, top(i) + kBoxHeight, x, y);
      if (!straight) out += line(x, y, left(tree.nodes()[child]), y);
    }
  }
  return out + "</g>\n";
}

std::string process_data_text(const SlaveConfig& slave) {
  const std::uint32_t outputs = slave.send ? slave.send->bit_length : 0,
                      inputs = slave.receive ? slave.receive->bit_length : 0;
  if (outputs == 0 && inputs == 0) return {};
  if (outputs % 8 != 0 || inputs % 8 != 0) return fmt::format("{} / {} bits", outputs, inputs);
  return fmt::format("{} / {} bytes", outputs / 8, inputs / 8);
}

const char* kind_of(const SlaveConfig& slave) {
  if (slave.dc && slave.dc->reference_clock) return "reference";
  return slave.dc && slave.dc->assign_activate != 0 ? "clocked" : "plain";
}

std::string box(const Node& node, std::size_t position, const SlaveConfig& slave) {
  const int x = left(node), y = top(position);
  std::string out = fmt::format("<g><title>{}</title>\n", markup_text(slave.name));
  out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" class=\"box{}\"/>\n", x, y, kBoxWidth,
                     kBoxHeight, slave.hot_connect ? " hot" : "");
  out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"6\" height=\"{}\" class=\"{}\"/>\n", x, y + 6, kBoxHeight - 12,
                     kind_of(slave));
  out += label(x + 18, y + 22, "name", fmt::format("{}  {}", position, shortened(slave.name, 34)));
  out += label(x + 18, y + 41, "detail",
               fmt::format("0x{:X} : 0x{:X} : 0x{:X}", slave.identity.vendor_id, slave.identity.product_code,
                           slave.identity.revision_no));
  out += label(x + kBoxWidth - 12, y + 22, "detail right", fmt::format("address {}", slave.station_address));
  out += label(x + kBoxWidth - 12, y + 41, "detail right", process_data_text(slave));
  // The master's cable has one place only.
  if (position > 0) out += label(x + kTrunk + 6, y - 5, "port", fmt::format("port {}", node.port));
  return out + "</g>\n";
}

std::string legend(int y) {
  std::string out;
  int x = kMargin;
  const std::pair<const char*, const char*> kinds[] = {
      {"reference", "reference clock"}, {"clocked", "synchronised"}, {"plain", "without SYNC"}};
  for (const auto& [kind, words] : kinds) {
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"6\" height=\"16\" class=\"{}\"/>\n", x, y, kind);
    out += label(x + 12, y + 13, "detail", words);
    x += 132;
  }
  return out;
}

constexpr const char* kStyle =
    "<style>\n"
    "text { font-family: 'Inter', 'Segoe UI', 'DejaVu Sans', sans-serif; fill: #1f2933; }\n"
    ".name { font-size: 14px; font-weight: 600; }\n"
    ".detail { font-size: 12px; fill: #52606d; }\n"
    ".right { text-anchor: end; }\n"
    ".port { font-size: 10px; fill: #7b8794; }\n"
    ".box { fill: #ffffff; stroke: #9aa5b1; stroke-width: 1.2; }\n"
    ".hot { stroke-dasharray: 6 4; }\n"
    ".master { fill: #243b53; }\n"
    ".master-name { font-size: 14px; font-weight: 600; fill: #ffffff; }\n"
    ".cable line { stroke: #627d98; stroke-width: 2; stroke-linecap: round; }\n"
    ".reference { fill: #de911d; }\n"
    ".clocked { fill: #2186eb; }\n"
    ".plain { fill: #cbd2d9; }\n"
    "</style>\n";

}  // namespace

std::string topology_svg(const NetworkConfig& config) {
  const Tree tree(config);
  const int width = 2 * kMargin + (tree.columns() - 1) * kIndent + kBoxWidth;
  const int height = top(config.slaves.size()) + kLegendHeight;
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n{2}<rect width=\"{0}\" height=\"{1}\" fill=\"#f5f7fa\"/>\n",
      width, height, kStyle);
  if (!config.slaves.empty()) out += cables(tree);
  out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" class=\"master\"/>\n", kMargin,
                     kMargin, kBoxWidth, kBoxHeight);
  out += label(kMargin + 18, kMargin + 31, "master-name",
               fmt::format("{}, {} slaves", shortened(config.master.name, 34), config.slaves.size()));
  for (std::size_t i = 0; i < config.slaves.size(); ++i) out += box(tree.nodes()[i], i, config.slaves[i]);
  return out + legend(top(config.slaves.size())) + "</svg>\n";
}

}  // namespace syncline::exports
