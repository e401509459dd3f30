// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <map>
#include <optional>

#include "channels/request_desk.h"

namespace syncline::ui {

class LiveSession;
class NetworkRun;

/// What became of a request.
enum class RequestState : unsigned char {
  kWaiting,
  kAnswered,
  kFailed,     // the slave or the master refused it
  kCancelled,  // by who asked
  kGone,       // the bus went offline, or was
};

struct RequestOutcome {
  RequestState state = RequestState::kWaiting;
  SlaveAnswer answer{};  // data or information when kAnswered
  QString why{};         // in words, what to do with it; empty when kAnswered
  [[nodiscard]] bool ok() const { return state == RequestState::kAnswered; }
};

/// Who waits for whom: what a person asked for goes before what fills a page.
enum class RequestUrgency : unsigned char { kPerson, kBackground };

/// The window's requests on single slaves of the bus of the network in work: any page asks, the master carries out
/// beside the cycle, and the answer comes back to who asked, out of the event loop and never out of post(), also when
/// another network is in work by then. So many are given to the master at once that it is never idle and that a
/// person's request does not wait behind a whole dictionary.
class SlaveRequests final : public QObject {
  Q_OBJECT

 public:
  using Id = std::uint64_t;
  using Done = std::function<void(const RequestOutcome&)>;
  /// With the master at once, of one slave and of all.
  static constexpr std::size_t kPerSlave = 16, kTotal = 48;

  explicit SlaveRequests(LiveSession& live, QObject* parent = nullptr);
  ~SlaveRequests() override;

  /// `slave`: position in the running configuration. `done` is called once, unless `asker` has gone or dropped it.
  Id post(SlaveRequest request, QObject& asker, Done done, RequestUrgency urgency = RequestUrgency::kPerson);
  /// kWaiting as long as it is under way; afterwards nothing is known of it.
  [[nodiscard]] std::optional<RequestState> state(Id id) const;
  /// Bytes that have been transferred so far, of long ones.
  [[nodiscard]] std::uint32_t progress(Id id) const;
  /// Its outcome will be kCancelled, unless it comes to its end before.
  void cancel(Id id);
  /// All of one asker end, and he hears nothing of them.
  void drop(const QObject& asker);
  [[nodiscard]] std::size_t waiting(const QObject& asker) const;

  /// There is a bus to ask: online, or on the way there.
  [[nodiscard]] bool possible() const;
  /// Something is being written to a slave.
  [[nodiscard]] bool writing() const;

 private:
  struct Open {
    SlaveRequest request;
    QPointer<QObject> asker;
    Done done;
    QPointer<NetworkRun> run;  // whose slave it is
    RequestUrgency urgency = RequestUrgency::kPerson;
    RequestId ticket = 0;  // 0: not yet with the master
    bool cancelled = false;
  };

  /// How many of one run are with its master.
  struct Load {
    std::map<std::uint16_t, std::size_t> per_slave;
    std::size_t all = 0;
  };

  void hear();
  void look(const NetworkRun& run);
  void submitAll(const NetworkRun& run);
  void submit(Id id, Open& open);
  [[nodiscard]] bool hasRoom(const Open& open) const;
  void count(const Open& open, bool more);
  void collect(const NetworkRun& run);
  void endAll();
  void deliver(Id id, RequestOutcome outcome);

  LiveSession& live_;
  std::map<Id, Open> open_;  // in their order
  std::map<const NetworkRun*, Load> loads_;
  Id last_ = 0;
};

}  // namespace syncline::ui
