// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace syncline::test {

/// A network namespace of the test's own with a veth pair in it, for the calling thread and the threads that
/// it starts; nothing of the machine's network is seen or touched. Not permitted everywhere: see ready().
class NetNamespace {
 public:
  static constexpr const char* kMasterEnd = "slm0";
  static constexpr const char* kBusEnd = "slb0";

  NetNamespace() : home_(::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC)) {
    if (home_ < 0 || ::unshare(CLONE_NEWNET) != 0) return;
    entered_ = true;
    const std::string pair = std::string("ip link add ") + kMasterEnd + " type veth peer name " + kBusEnd;
    ready_ = run(pair) && set_up(kMasterEnd, true) && set_up(kBusEnd, true) && carries(kMasterEnd) && carries(kBusEnd);
  }
  ~NetNamespace() {
    if (entered_) (void)::setns(home_, CLONE_NEWNET);
    if (home_ >= 0) ::close(home_);
  }
  NetNamespace(const NetNamespace&) = delete;
  NetNamespace& operator=(const NetNamespace&) = delete;

  /// False: no permission for namespaces or no `ip` tool; the test skips.
  [[nodiscard]] bool ready() const { return ready_; }
  static bool set_up(const std::string& adapter, bool up) {
    return run("ip link set " + adapter + (up ? " up" : " down"));
  }

 private:
  /// The kernel reports the carrier of a new pair a little later.
  static bool carries(const std::string& adapter) {
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    ifreq about{};
    adapter.copy(about.ifr_name, IFNAMSIZ - 1);
    bool running = false;
    for (int tries = 0; !running && tries < 10'000; ++tries) {
      running = ::ioctl(socket, SIOCGIFFLAGS, &about) == 0 && (about.ifr_flags & IFF_RUNNING) != 0;
      if (!running) ::usleep(1'000);
    }
    ::close(socket);
    return running;
  }
  static bool run(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

  int home_;
  bool entered_ = false, ready_ = false;
};

}  // namespace syncline::test
