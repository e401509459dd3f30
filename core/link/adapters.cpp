// SPDX-License-Identifier: Apache-2.0
#include <ifaddrs.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <netpacket/packet.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "link/pcap_link.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  return line;
}

/// "" for interfaces without a device, such as veth and bridges.
std::string driver_of(const std::string& name) {
  std::error_code error;
  const auto link = fs::read_symlink(fs::path("/sys/class/net") / name / "device" / "driver", error);
  return error ? std::string{} : link.filename().string();
}

/// Wireless cards call themselves Ethernet too, but carry no foreign frame types in time.
bool is_wireless(const std::string& name) {
  std::error_code error;
  return fs::exists(fs::path("/sys/class/net") / name / "phy80211", error);
}

bool is_up(const std::string& name, unsigned flags) {
  // A veth end reports "up" only while its peer is up; "unknown" is what drivers without carrier say.
  const auto state = first_line(fs::path("/sys/class/net") / name / "operstate");
  return (flags & IFF_UP) != 0 && (state == "up" || state == "unknown");
}

}  // namespace

Result<std::vector<AdapterInfo>> list_adapters() {
  // getifaddrs needs no permission; pcap_findalldevs hides cards from users who may not open them.
  ifaddrs* raw = nullptr;
  if (::getifaddrs(&raw) != 0) return fail(ErrorCode::kLinkIo, "network adapters", std::strerror(errno));
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> list(raw, &::freeifaddrs);

  std::vector<AdapterInfo> adapters;
  for (const auto* entry = list.get(); entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_PACKET) continue;
    sockaddr_ll address{};
    std::memcpy(&address, entry->ifa_addr, sizeof(address));
    if ((entry->ifa_flags & IFF_LOOPBACK) != 0 || address.sll_hatype != ARPHRD_ETHER || address.sll_halen != 6) continue;
    if (is_wireless(entry->ifa_name)) continue;
    AdapterInfo adapter;
    adapter.name = entry->ifa_name;
    std::copy_n(address.sll_addr, 6, adapter.mac.begin());
    adapter.driver = driver_of(adapter.name);
    adapter.description = adapter.driver.empty() ? "virtual Ethernet" : "Ethernet, driver " + adapter.driver;
    adapter.up = is_up(adapter.name, entry->ifa_flags);
    adapters.push_back(std::move(adapter));
  }
  std::sort(adapters.begin(), adapters.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return adapters;
}

}  // namespace syncline
