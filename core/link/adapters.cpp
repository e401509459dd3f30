// SPDX-License-Identifier: Apache-2.0
#include <ifaddrs.h>
#include <linux/ethtool.h>
#include <linux/if_packet.h>
#include <linux/sockios.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "link/pcap_link.h"

namespace syncline {
namespace {

/// Asks the kernel about one interface. By ioctl and not by /sys: that shows the network namespace in which it
/// was mounted, not the one in which we are.
bool ask(unsigned long request, ifreq& about) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return false;
  const bool answered = ::ioctl(socket, request, &about) == 0;
  ::close(socket);
  return answered;
}

ifreq about_interface(const std::string& name) {
  ifreq about{};
  name.copy(about.ifr_name, IFNAMSIZ - 1);
  return about;
}

/// "" when the driver does not tell.
std::string driver_of(const std::string& name) {
  ethtool_drvinfo info{};
  info.cmd = ETHTOOL_GDRVINFO;
  auto about = about_interface(name);
  about.ifr_data = reinterpret_cast<char*>(&info);
  if (!ask(SIOCETHTOOL, about)) return {};
  return {info.driver, ::strnlen(info.driver, sizeof(info.driver))};
}

/// Wireless cards call themselves Ethernet too, but carry no foreign frame types in time.
bool is_wireless(const std::string& name) {
  constexpr unsigned long kGetWirelessName = 0x8B01;  // SIOCGIWNAME of linux/wireless.h, which clashes with net/if.h
  auto about = about_interface(name);
  return ask(kGetWirelessName, about);
}

/// The kernel sets IFF_RUNNING while there is a carrier, or the driver knows of none. A veth end has it only
/// while its peer is up.
bool is_up(unsigned flags) { return (flags & IFF_UP) != 0 && (flags & IFF_RUNNING) != 0; }

}  // namespace

Result<std::vector<AdapterInfo>> list_adapters() {
  // getifaddrs needs no permission; pcap_findalldevs hides cards from users who may not open them.
  ifaddrs* raw = nullptr;
  if (::getifaddrs(&raw) != 0) return fail(ErrorCode::kLinkIo, "network adapters", Reason::of_system(errno));
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> list(raw, &::freeifaddrs);

  std::vector<AdapterInfo> adapters;
  for (const auto* entry = list.get(); entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_PACKET) continue;
    sockaddr_ll address{};
    std::memcpy(&address, entry->ifa_addr, sizeof(address));
    if ((entry->ifa_flags & IFF_LOOPBACK) != 0 || address.sll_hatype != ARPHRD_ETHER || address.sll_halen != 6)
      continue;
    if (is_wireless(entry->ifa_name)) continue;
    AdapterInfo adapter;
    adapter.name = entry->ifa_name;
    std::copy_n(address.sll_addr, 6, adapter.mac.begin());
    adapter.driver = driver_of(adapter.name);
    adapter.description = adapter.driver.empty() ? "Ethernet" : "Ethernet, driver " + adapter.driver;
    adapter.up = is_up(entry->ifa_flags);
    adapters.push_back(std::move(adapter));
  }
  std::sort(adapters.begin(), adapters.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return adapters;
}

}  // namespace syncline
