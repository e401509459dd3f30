// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "channels/slave_request.h"
#include "protocol/sdo_information.h"
#include "ui/models/dictionary.h"

namespace syncline::ui {

class SlaveRequests;
struct RequestOutcome;

/// Reads the object dictionary of a running slave out of the slave (SDO information), in the background of what people
/// ask meanwhile. One at a time.
class DictionaryReader final : public QObject {
  Q_OBJECT

 public:
  explicit DictionaryReader(SlaveRequests& requests, QObject* parent = nullptr);

  /// `slave`: position in the running configuration. Ends one that runs.
  void start(std::uint16_t slave, coe::ObjectListType list);
  void cancel();
  [[nodiscard]] bool isRunning() const { return running_; }

 Q_SIGNALS:
  /// These objects there are; nothing more is known of them yet.
  void listed(const std::vector<std::uint16_t>& indices);
  void objectRead(const syncline::ui::DictionaryObject& object);
  void progressed(int objects, int of);
  /// All objects have been asked for, and each was told or refused by the slave (an SDO abort).
  void finished();
  /// It broke off: some are not known.
  void failed(const QString& why);

 private:
  struct Pending {
    DictionaryObject object{};
    int open = 0;              // entries without an answer
    bool repeat_last = false;  // a long array: its elements are alike
    std::uint8_t last = 0;
  };
  /// Elements of longer arrays are not asked for one by one.
  static constexpr int kLongArray = 16;

  void ask(SlaveRequest request, std::function<void(const RequestOutcome&)> what);
  void takeList(const coe::ObjectList& list);
  void takeObject(const coe::ObjectDescription& told);
  void takeEntry(std::uint16_t index, const coe::EntryDescription* told);
  void complete(std::uint16_t index);
  void end();

  SlaveRequests& requests_;
  std::map<std::uint16_t, Pending> pending_;
  std::uint16_t slave_ = 0;
  int objects_ = 0, done_ = 0;
  bool running_ = false;
};

}  // namespace syncline::ui
