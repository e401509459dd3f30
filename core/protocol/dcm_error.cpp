// SPDX-License-Identifier: Apache-2.0
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

struct DcmError {
  std::uint32_t code;
  std::string_view name, text;
};
constexpr DcmError kErrors[] = {
    {kDcmErrorUnspecific, "DCM_E_ERROR", "The master synchronisation failed."},
    {kDcmErrorNotInitialised, "DCM_E_NOTINITIALIZED",
     "The master synchronisation is not running; bring the bus to PREOP first."},
    {kDcmErrorOutOfLimit, "DCM_E_MAX_CTL_ERROR_EXCEED",
     "The control error left its limit; look at the host's jitter, lost frames and the reference clock."},
    {kDcmErrorNoMemory, "DCM_E_NOMEMORY", "There is not enough memory."},
    {kDcmErrorInvalidHardwareLayer, "DCM_E_INVALID_HWLAYER", "The link cannot put its send time into the frames."},
    {kDcmErrorTimerModify, "DCM_E_TIMER_MODIFY_ERROR",
     "The host's timer cannot be adjusted as far as the controller demands."},
    {kDcmErrorTimerNotRunning, "DCM_E_TIMER_NOT_RUNNING", "The host's cycle has stopped."},
    {kDcmErrorWrongCpu, "DCM_E_WRONG_CPU", "The cyclic thread runs on another processor than it is bound to."},
    {kDcmErrorInvalidSyncPeriod, "DCM_E_INVALID_SYNC_PERIOD",
     "A SYNC0 cycle does not fit the bus cycle; make it a multiple or a divisor."},
    {kDcmErrorInvalidSetValue, "DCM_E_INVALID_SETVAL",
     "The set value is too small: at SYNC0 the frame is still on its way; raise it above frame time plus propagation "
     "delay, "
     "below the cycle."},
    {kDcmErrorDriftTooHigh, "DCM_E_DRIFT_TO_HIGH",
     "Host and reference clock drift apart by more than 600 ppm; look at the host's timer or choose another reference "
     "clock."},
    {kDcmErrorBusCycleWrong, "DCM_E_BUS_CYCLE_WRONG", "The cycles do not come with the configured cycle time."},
    {kDcxErrorNoExternalClock, "DCX_E_NO_EXT_CLOCK",
     "No external clock was found; look at the bridge device and at the network on its other side."},
    {kDcmErrorInvalidData, "DCM_E_INVALID_DATA", "The configuration does not hold what this mode needs."},
};

const DcmError* find(std::uint32_t code) {
  for (const auto& error : kErrors) {
    if (error.code == code) return &error;
  }
  return nullptr;
}

}  // namespace

std::string_view dcm_error_name(std::uint32_t code) {
  const auto* error = find(code);
  return error != nullptr ? error->name : std::string_view{};
}

std::string_view dcm_error_text(std::uint32_t code) {
  const auto* error = find(code);
  return error != nullptr ? error->text : std::string_view{};
}

}  // namespace syncline::dc
