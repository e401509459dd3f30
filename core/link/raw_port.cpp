// SPDX-License-Identifier: Apache-2.0
#include "link/raw_port.h"

#include <net/if.h>
#include <pcap/pcap.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "link/pcap_link.h"
#include "link/send_socket.h"
#include "protocol/frame.h"
#include "reasons/because.h"
#include "support/calendar_stamp.h"
#include "support/clock.h"

namespace syncline {
namespace {

struct PortCloser {
  void operator()(pcap_t* handle) const { pcap_close(handle); }
};
using PcapHandle = std::unique_ptr<pcap_t, PortCloser>;

std::string up_command(const std::string& adapter) { return "sudo ip link set " + adapter + " up"; }

Result<AdapterInfo> find_adapter(const std::string& name) {
  auto adapters = list_adapters();
  if (!adapters) return tl::unexpected(adapters.error());
  const auto found = std::ranges::find(*adapters, name, &AdapterInfo::name);
  if (found == adapters->end()) {
    std::string names;
    for (const auto& adapter : *adapters) names += (names.empty() ? "" : ", ") + adapter.name;
    return fail(ErrorCode::kLinkNotFound, name,
                names.empty() ? because("this machine has no Ethernet adapter") : because("there are: {names}", names));
  }
  if (!found->up) return fail(ErrorCode::kLinkDown, name, Reason::verbatim(up_command(name)));
  return *found;
}

Status set_filter(pcap_t* handle, const std::string& name) {
  bpf_program program{};
  if (pcap_compile(handle, &program, "ether proto 0x88a4", 1, PCAP_NETMASK_UNKNOWN) != 0) {
    return fail(ErrorCode::kLinkIo, name, Reason::phrase(pcap_geterr(handle)));
  }
  const int result = pcap_setfilter(handle, &program);
  pcap_freecode(&program);
  if (result != 0) return fail(ErrorCode::kLinkIo, name, Reason::phrase(pcap_geterr(handle)));
  return {};
}

Status activate(pcap_t* handle, const std::string& adapter) {
  const int result = pcap_activate(handle);
  if (result == PCAP_ERROR_PERM_DENIED || result == PCAP_ERROR_PROMISC_PERM_DENIED) {
    return fail(ErrorCode::kLinkPermission, adapter, Reason::verbatim(permission_command()));
  }
  if (result == PCAP_ERROR_IFACE_NOT_UP)
    return fail(ErrorCode::kLinkDown, adapter, Reason::verbatim(up_command(adapter)));
  if (result < 0) return fail(ErrorCode::kLinkIo, adapter, Reason::phrase(pcap_geterr(handle)));
  if (pcap_datalink(handle) != DLT_EN10MB)
    return fail(ErrorCode::kNotSupported, adapter, because("not an Ethernet adapter"));
  return {};
}

/// Switched on, and something at the other end of the cable.
bool is_running(const std::string& adapter) {
  const int fd = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  ifreq request{};
  adapter.copy(request.ifr_name, IFNAMSIZ - 1);
  const bool known = ::ioctl(fd, SIOCGIFFLAGS, &request) == 0;
  ::close(fd);
  return known && (request.ifr_flags & IFF_UP) != 0 && (request.ifr_flags & IFF_RUNNING) != 0;
}

/// An adapter that is away is looked for so often.
constexpr Nanoseconds kLookAgain = 50 * kMillisecond;

}  // namespace

std::string permission_command() {
  std::error_code error;
  const auto binary = std::filesystem::read_symlink("/proc/self/exe", error);
  return "sudo setcap cap_net_raw,cap_net_admin,cap_sys_nice,cap_ipc_lock=ep " +
         (error ? std::string("synclinectl") : binary.string());
}

struct RawPort::Impl {
  PcapHandle handle;
  AdapterInfo adapter;
  Clock& clock;
  int fd = -1;
  bool sees_own = false;
  Nanoseconds stamp_unit = 1;  // of the fraction in the kernel's stamp
  std::optional<SendSocket> way_out;
  CalendarStamp stamps;  // of what is sent
  ArrivalStamp arrivals;
  std::optional<Nanoseconds> sent_at;
  bool stamps_sending = false;
  std::optional<Nanoseconds> away{};  // the adapter is; when it was looked for last

  /// The kernel's stamp on the port's clock.
  [[nodiscard]] Nanoseconds arrival_time(const pcap_pkthdr& header) {
    return arrivals.to_clock(header.ts.tv_sec * kSecond + header.ts.tv_usec * stamp_unit);
  }
};

Result<RawPort> RawPort::open(const std::string& adapter, Clock& clock, bool stamps_sending) {
  auto info = find_adapter(adapter);
  if (!info) return tl::unexpected(info.error());

  char text[PCAP_ERRBUF_SIZE] = {};
  PcapHandle handle(pcap_create(adapter.c_str(), text));
  if (!handle) return fail(ErrorCode::kLinkIo, adapter, Reason::phrase(text));
  pcap_set_snaplen(handle.get(), static_cast<int>(kMaxEthernetFrame) + 4);
  pcap_set_promisc(handle.get(), 1);
  pcap_set_immediate_mode(handle.get(), 1);
  pcap_set_timeout(handle.get(), 1);
  const bool nanoseconds = pcap_set_tstamp_precision(handle.get(), PCAP_TSTAMP_PRECISION_NANO) == 0;
  if (auto status = activate(handle.get(), adapter); !status) return tl::unexpected(status.error());
  if (auto status = set_filter(handle.get(), adapter); !status) return tl::unexpected(status.error());
  const bool sees_own = pcap_setdirection(handle.get(), PCAP_D_IN) != 0;
  if (pcap_setnonblock(handle.get(), 1, text) != 0) return fail(ErrorCode::kLinkIo, adapter, Reason::phrase(text));
  const int fd = pcap_get_selectable_fd(handle.get());
  return RawPort(
      std::unique_ptr<Impl>(new Impl{std::move(handle), std::move(*info), clock, fd, sees_own,
                                     nanoseconds ? 1 : kMicrosecond, SendSocket::open(adapter, stamps_sending),
                                     CalendarStamp(clock), ArrivalStamp(clock), std::nullopt, stamps_sending}));
}

RawPort::RawPort(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RawPort::RawPort(RawPort&&) noexcept = default;
RawPort& RawPort::operator=(RawPort&&) noexcept = default;
RawPort::~RawPort() = default;

/// What a failed call means: an adapter that is away may come back, anything else is final.
Error RawPort::failed(Reason why) {
  auto& adapter = impl_->adapter;
  if (is_running(adapter.name)) {
    // It was away for a moment, and its sockets have not got over it.
    if (auto again = open(adapter.name, impl_->clock, impl_->stamps_sending)) {
      impl_ = std::move(again->impl_);
      return {ErrorCode::kLinkDown, impl_->adapter.name, because("it was away for a moment")};
    }
    return {ErrorCode::kLinkIo, adapter.name, std::move(why)};
  }
  adapter.up = false;
  impl_->away = impl_->clock.now();
  return {ErrorCode::kLinkDown, adapter.name, std::move(why)};
}

/// False as long as the adapter is away.
bool RawPort::come_back() {
  if (!impl_->away) return true;
  const auto now = impl_->clock.now();
  if (now - *impl_->away < kLookAgain) return false;
  impl_->away = now;
  if (!is_running(impl_->adapter.name)) return false;
  // Perhaps another one under the same name: everything anew.
  auto again = open(impl_->adapter.name, impl_->clock, impl_->stamps_sending);
  if (again) impl_ = std::move(again->impl_);
  return again.has_value();
}

Result<std::optional<RawPort::Frame>> RawPort::poll() {
  if (!come_back()) return fail(ErrorCode::kLinkDown, impl_->adapter.name);
  pcap_pkthdr* header = nullptr;
  const u_char* bytes = nullptr;
  const int found = pcap_next_ex(impl_->handle.get(), &header, &bytes);
  if (found < 0) return tl::unexpected(failed(Reason::phrase(pcap_geterr(impl_->handle.get()))));
  if (found == 0) return std::optional<Frame>{};
  return Frame{{bytes, header->caplen}, impl_->arrival_time(*header)};
}

void RawPort::wait(Nanoseconds duration) const {
  if (duration <= 0) return;
  pollfd entry{impl_->fd, POLLIN, 0};
  const timespec time{static_cast<time_t>(duration / kSecond), static_cast<long>(duration % kSecond)};
  // ppoll: poll's millisecond is longer than many bus cycles.
  (void)::ppoll(&entry, 1, &time, nullptr);
}

Status RawPort::send(std::span<const std::uint8_t> frame) {
  if (!come_back()) return fail(ErrorCode::kLinkDown, impl_->adapter.name);
  impl_->sent_at.reset();
  if (auto& way_out = impl_->way_out) {
    const auto before = impl_->clock.now();
    if (auto status = way_out->send(frame); !status) return tl::unexpected(failed(status.error().detail));
    // The kernel drops what finds no carrier, as it drops what finds no room.
    if (way_out->dropped() && !is_running(impl_->adapter.name)) return tl::unexpected(failed(because("no carrier")));
    if (const auto stamp = way_out->take_stamp()) impl_->sent_at = impl_->stamps.to_clock(*stamp, before);
    return {};
  }
  if (pcap_inject(impl_->handle.get(), frame.data(), frame.size()) != static_cast<int>(frame.size())) {
    return tl::unexpected(failed(Reason::phrase(pcap_geterr(impl_->handle.get()))));
  }
  return {};
}

std::optional<Nanoseconds> RawPort::sent_at() const { return impl_->sent_at; }

const AdapterInfo& RawPort::adapter() const { return impl_->adapter; }
bool RawPort::sees_own() const { return impl_->sees_own; }

std::uint64_t RawPort::dropped() const {
  pcap_stat statistics{};
  return pcap_stats(impl_->handle.get(), &statistics) == 0 ? statistics.ps_drop : 0;
}

}  // namespace syncline
