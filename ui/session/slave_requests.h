// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <map>
#include <vector>

#include "record/request_queue.h"

namespace syncline::ui {

class LiveSession;
class NetworkRun;

/// What became of a request.
struct RequestOutcome {
  RequestEnd end = RequestEnd::kAnswered;
  SlaveAnswer answer{};  // data or information when kAnswered
  QString why{};         // in words, what to do with it; empty when kAnswered
  [[nodiscard]] bool ok() const { return end == RequestEnd::kAnswered; }
};

/// The window's requests on single slaves of the bus of the network in work: any page asks, the master carries out
/// beside the cycle, and the answer comes back to who asked, out of the event loop and never out of post(), also when
/// another network is in work by then. Each run has a RequestQueue.
class SlaveRequests final : public QObject {
  Q_OBJECT

 public:
  using Id = RequestQueue::Id;
  using Done = std::function<void(const RequestOutcome&)>;

  explicit SlaveRequests(LiveSession& live, QObject* parent = nullptr);
  ~SlaveRequests() override;

  /// `slave`: position in the running configuration. `done` is called once, unless `asker` has gone or dropped it.
  Id post(SlaveRequest request, QObject& asker, Done done, RequestUrgency urgency = RequestUrgency::kPerson);
  /// As long as it is under way.
  [[nodiscard]] bool isWaiting(Id id) const { return open_.contains(id); }
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
    QPointer<QObject> asker;
    Done done;
    QPointer<NetworkRun> run;  // whose slave it is
    bool writes = false;
  };

  RequestQueue& queueOf(NetworkRun& run);
  void look(const NetworkRun& run);
  void lookLater(const NetworkRun& run);
  void endAll();
  void tell(std::vector<RequestQueue::Ended> all);
  void deliver(Id id, const RequestOutcome& outcome);

  LiveSession& live_;
  std::map<Id, Open> open_;
  std::map<const NetworkRun*, RequestQueue> queues_;
  Id last_ = 0;
};

}  // namespace syncline::ui
