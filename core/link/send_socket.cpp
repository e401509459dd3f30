// SPDX-License-Identifier: Apache-2.0
#include "link/send_socket.h"

#include <arpa/inet.h>
#include <linux/errqueue.h>
#include <linux/if_packet.h>
#include <linux/net_tstamp.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace syncline {
namespace {

/// A driver that has not stamped so many frames in a row does not stamp, and is not asked any more.
constexpr int kGivesNone = 32;

bool set(int fd, int level, int name, int value) { return ::setsockopt(fd, level, name, &value, sizeof(value)) == 0; }

/// No protocol: the socket is for sending only.
int open_packet_socket(const std::string& adapter) {
  const int fd = ::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd < 0) return fd;
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_ifindex = static_cast<int>(::if_nametoindex(adapter.c_str()));
  sockaddr_storage bytes{};
  std::memcpy(&bytes, &address, sizeof(address));
  if (address.sll_ifindex != 0 && ::bind(fd, reinterpret_cast<const sockaddr*>(&bytes), sizeof(address)) == 0)
    return fd;
  ::close(fd);
  return -1;
}

/// One message of the error queue: which frame it is about, and when the driver got it.
struct Stamp {
  std::uint32_t frame = 0;
  std::optional<Nanoseconds> time;
};

Stamp read_stamp(msghdr& message) {
  Stamp stamp;
  for (auto* control = CMSG_FIRSTHDR(&message); control != nullptr; control = CMSG_NXTHDR(&message, control)) {
    if (control->cmsg_level == SOL_SOCKET && control->cmsg_type == SCM_TIMESTAMPING) {
      scm_timestamping times{};
      std::memcpy(&times, CMSG_DATA(control), sizeof(times));
      const auto& software = times.ts[0];
      if (software.tv_sec != 0) stamp.time = static_cast<Nanoseconds>(software.tv_sec) * kSecond + software.tv_nsec;
    } else if (control->cmsg_level == SOL_PACKET && control->cmsg_type == PACKET_TX_TIMESTAMP) {
      sock_extended_err about{};
      std::memcpy(&about, CMSG_DATA(control), sizeof(about));
      stamp.frame = about.ee_data;
    }
  }
  return stamp;
}

}  // namespace

std::optional<SendSocket> SendSocket::open(const std::string& adapter, bool stamped) {
  const int fd = open_packet_socket(adapter);
  if (fd < 0) return std::nullopt;
  SendSocket socket(fd);
  (void)set(fd, SOL_PACKET, PACKET_QDISC_BYPASS, 1);
  // RX_SOFTWARE switches the kernel's stamps on for all sockets: libpcap's frames are then stamped when they leave the
  // driver and not when their turn comes.
  constexpr int kArrival = SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE;
  constexpr int kSending = SOF_TIMESTAMPING_TX_SOFTWARE | SOF_TIMESTAMPING_OPT_ID | SOF_TIMESTAMPING_OPT_TSONLY;
  socket.stamped_ = set(fd, SOL_SOCKET, SO_TIMESTAMPING, stamped ? kArrival | kSending : kArrival) && stamped;
  return socket;
}

SendSocket::SendSocket(SendSocket&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      stamped_(other.stamped_),
      sent_(other.sent_),
      without_stamp_(other.without_stamp_) {}

SendSocket& SendSocket::operator=(SendSocket&& other) noexcept {
  std::swap(fd_, other.fd_);
  stamped_ = other.stamped_;
  sent_ = other.sent_;
  without_stamp_ = other.without_stamp_;
  return *this;
}

SendSocket::~SendSocket() {
  if (fd_ >= 0) ::close(fd_);
}

Status SendSocket::send(std::span<const std::uint8_t> frame) {
  if (::send(fd_, frame.data(), frame.size(), 0) == static_cast<ssize_t>(frame.size())) {
    ++sent_;
    dropped_ = false;
    return {};
  }
  if (errno == ENOBUFS || errno == EAGAIN || errno == EBUSY || errno == EINTR) {
    ++sent_;  // the kernel has counted it
    dropped_ = true;
    return {};
  }
  return fail(ErrorCode::kLinkIo, "network adapter", Reason::of_system(errno));
}

std::optional<Nanoseconds> SendSocket::take_stamp() {
  if (!stamped_) return std::nullopt;
  std::optional<Nanoseconds> last;
  for (;;) {
    alignas(cmsghdr) std::array<char, 256> control{};
    msghdr message{};
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    if (::recvmsg(fd_, &message, MSG_ERRQUEUE | MSG_DONTWAIT) < 0) break;
    const auto stamp = read_stamp(message);
    if (stamp.frame + 1 == sent_) {
      last = stamp.time;
      break;  // the newest: nothing is behind it
    }
  }
  without_stamp_ = last ? 0 : without_stamp_ + 1;
  if (without_stamp_ >= kGivesNone) stamped_ = false;
  return last;
}

}  // namespace syncline
