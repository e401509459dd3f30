// SPDX-License-Identifier: Apache-2.0
#include "link/pcap_link.h"

#include <pcap/pcap.h>
#include <poll.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "protocol/frame.h"

namespace syncline {
namespace {

constexpr std::uint8_t kLocallyAdministered = 0x02;

struct PcapCloser {
  void operator()(pcap_t* handle) const { pcap_close(handle); }
};
using PcapHandle = std::unique_ptr<pcap_t, PcapCloser>;

/// What the user has to type to let this very binary open network cards.
std::string permission_command() {
  std::error_code error;
  const auto binary = std::filesystem::read_symlink("/proc/self/exe", error);
  return "sudo setcap cap_net_raw,cap_net_admin,cap_sys_nice,cap_ipc_lock=ep " +
         (error ? std::string("synclinectl") : binary.string());
}

class PcapLink final : public Link {
 public:
  /// `sees_own`: the adapter cannot tell directions apart, so what was sent comes back as received.
  PcapLink(PcapHandle handle, AdapterInfo adapter, bool sees_own, Clock& clock)
      : handle_(std::move(handle)),
        adapter_(std::move(adapter)),
        source_(adapter_.mac),
        sees_own_(sees_own),
        clock_(clock),
        fd_(pcap_get_selectable_fd(handle_.get())) {
    // The first ESC sets this bit. Frames leave without it, so that a returned frame differs from a
    // sent one on cards whose own address has it (veth, USB adapters).
    source_[0] &= static_cast<std::uint8_t>(~kLocallyAdministered);
  }

  Status send(std::span<const std::uint8_t> frame) override {
    if (pcap_inject(handle_.get(), frame.data(), frame.size()) != static_cast<int>(frame.size())) {
      return fail(ErrorCode::kLinkIo, adapter_.name, pcap_geterr(handle_.get()));
    }
    return {};
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    for (;;) {
      pcap_pkthdr* header = nullptr;
      const u_char* bytes = nullptr;
      const int found = pcap_next_ex(handle_.get(), &header, &bytes);
      if (found < 0) return fail(ErrorCode::kLinkIo, adapter_.name, pcap_geterr(handle_.get()));
      if (found == 1) {
        const std::span<const std::uint8_t> frame(bytes, std::min<std::size_t>(header->caplen, buffer.size()));
        if (is_echo(frame)) continue;
        std::copy(frame.begin(), frame.end(), buffer.begin());
        return ReceivedFrame{frame.size(), clock_.now()};
      }
      const auto left = deadline - clock_.now();
      if (left <= 0) return ReceivedFrame{};
      wait(left);
    }
  }

  [[nodiscard]] LinkDescription describe() const override {
    return {"nic:" + adapter_.name, "nic", source_, adapter_.up, false};
  }

 private:
  /// Our own frame as it left. Where the adapter tells directions apart the address says nothing: a
  /// segment with DL control bit 0 cleared returns it unchanged.
  [[nodiscard]] bool is_echo(std::span<const std::uint8_t> frame) const {
    return sees_own_ && frame.size() >= kEthernetHeaderSize &&
           std::equal(source_.begin(), source_.end(), frame.begin() + 6);
  }

  void wait(Nanoseconds left) const {
    pollfd entry{fd_, POLLIN, 0};
    timespec time{static_cast<time_t>(left / kSecond), static_cast<long>(left % kSecond)};
    // ppoll: poll's millisecond is longer than many bus cycles.
    (void)::ppoll(&entry, 1, &time, nullptr);
  }

  PcapHandle handle_;
  AdapterInfo adapter_;
  MacAddress source_;
  bool sees_own_;
  Clock& clock_;
  int fd_;
};

Result<AdapterInfo> find_adapter(const std::string& name) {
  auto adapters = list_adapters();
  if (!adapters) return tl::unexpected(adapters.error());
  const auto found = std::find_if(adapters->begin(), adapters->end(), [&name](const auto& a) { return a.name == name; });
  if (found == adapters->end()) {
    std::string names;
    for (const auto& adapter : *adapters) names += (names.empty() ? "" : ", ") + adapter.name;
    return fail(ErrorCode::kLinkNotFound, name, names.empty() ? "this machine has no Ethernet adapter" : "there are: " + names);
  }
  if (!found->up) return fail(ErrorCode::kLinkDown, name, "sudo ip link set " + name + " up");
  return *found;
}

Status set_filter(pcap_t* handle, const std::string& name) {
  bpf_program program{};
  if (pcap_compile(handle, &program, "ether proto 0x88a4", 1, PCAP_NETMASK_UNKNOWN) != 0) {
    return fail(ErrorCode::kLinkIo, name, pcap_geterr(handle));
  }
  const int result = pcap_setfilter(handle, &program);
  pcap_freecode(&program);
  if (result != 0) return fail(ErrorCode::kLinkIo, name, pcap_geterr(handle));
  return {};
}

}  // namespace

Result<std::unique_ptr<Link>> open_pcap_link(const std::string& adapter, Clock& clock) {
  const auto info = find_adapter(adapter);
  if (!info) return tl::unexpected(info.error());

  char text[PCAP_ERRBUF_SIZE] = {};
  PcapHandle handle(pcap_create(adapter.c_str(), text));
  if (!handle) return fail(ErrorCode::kLinkIo, adapter, text);
  pcap_set_snaplen(handle.get(), static_cast<int>(kMaxEthernetFrame) + 4);
  pcap_set_promisc(handle.get(), 1);
  pcap_set_immediate_mode(handle.get(), 1);
  pcap_set_timeout(handle.get(), 1);
  const int activated = pcap_activate(handle.get());
  if (activated == PCAP_ERROR_PERM_DENIED || activated == PCAP_ERROR_PROMISC_PERM_DENIED) {
    return fail(ErrorCode::kLinkPermission, adapter, permission_command());
  }
  if (activated == PCAP_ERROR_IFACE_NOT_UP) return fail(ErrorCode::kLinkDown, adapter, "sudo ip link set " + adapter + " up");
  if (activated < 0) return fail(ErrorCode::kLinkIo, adapter, pcap_geterr(handle.get()));
  if (pcap_datalink(handle.get()) != DLT_EN10MB) return fail(ErrorCode::kNotSupported, adapter, "not an Ethernet adapter");
  if (auto status = set_filter(handle.get(), adapter); !status) return tl::unexpected(status.error());
  const bool sees_own = pcap_setdirection(handle.get(), PCAP_D_IN) != 0;
  if (pcap_setnonblock(handle.get(), 1, text) != 0) return fail(ErrorCode::kLinkIo, adapter, text);
  return std::make_unique<PcapLink>(std::move(handle), *info, sees_own, clock);
}

}  // namespace syncline
