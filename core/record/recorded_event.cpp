// SPDX-License-Identifier: Apache-2.0
#include "record/recorded_event.h"

#include <string>
#include <utility>

#include "channels/event.h"
#include "channels/event_name.h"
#include "channels/event_text.h"
#include "record/recording.h"
#include "record/typed_values.h"

namespace syncline {

std::optional<RecordedEvent> recorded_event(const Event& event) {
  auto words = event_words(event);
  if (words.empty()) return std::nullopt;
  return RecordedEvent{event.time, event.slave, std::string(event_name(event)), std::move(words),
                       encode_event(event.what)};
}

}  // namespace syncline
