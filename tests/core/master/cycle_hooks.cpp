// SPDX-License-Identifier: Apache-2.0
#include "cycle_hooks.h"

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

#include <cerrno>
#include <cstdlib>
#include <new>

// A sanitizer has hooks of its own in the places of malloc and of the locks; operator new is left to us.
#if defined(SYNCLINE_SANITIZED)
#define SYNCLINE_HOOKS_LIBC 0
#else
#define SYNCLINE_HOOKS_LIBC 1
#endif

namespace {

thread_local syncline::test::CycleCounts* counts = nullptr;

void count_allocation() {
  if (counts != nullptr) ++counts->allocations;
}

#if SYNCLINE_HOOKS_LIBC
void count_lock() {
  if (counts != nullptr) ++counts->locks;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
#endif

void* allocate(std::size_t size) {
#if !SYNCLINE_HOOKS_LIBC
  count_allocation();
#endif
  return std::malloc(size == 0 ? 1 : size);
}

void* allocate_or_throw(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// With inlining the compiler sees malloc on one side only and takes the pair for a mismatch.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
// By default these forms end in the ones above, but a sanitizer brings its own: std::stable_partition would
// get memory from the sanitizer and give it back to us.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

#if SYNCLINE_HOOKS_LIBC
extern "C" {

// The names under which glibc keeps its own for those who stand in front of them.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  count_allocation();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  count_allocation();
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  count_allocation();
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count_allocation();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  count_allocation();
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  static auto* const lock = next<int(pthread_mutex_t*)>("pthread_mutex_lock");
  count_lock();
  return lock(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  static auto* const lock = next<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  count_lock();
  return lock(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* mutex) {
  static auto* const lock = next<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  count_lock();
  return lock(mutex);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* mutex) {
  static auto* const lock = next<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  count_lock();
  return lock(mutex);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  static auto* const wait = next<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
  count_lock();
  return wait(condition, mutex);
}
int sem_wait(sem_t* semaphore) {
  static auto* const wait = next<int(sem_t*)>("sem_wait");
  count_lock();
  return wait(semaphore);
}

}  // extern "C"
#endif

namespace syncline::test {
namespace {

class Pause {
 public:
  Pause() : before_(counts) { counts = nullptr; }
  ~Pause() { counts = before_; }
  Pause(const Pause&) = delete;
  Pause& operator=(const Pause&) = delete;

 private:
  CycleCounts* before_;
};

}  // namespace

CountingCycle::CountingCycle(CycleCounts& here) : before_(counts) { counts = &here; }
CountingCycle::~CountingCycle() { counts = before_; }

Status UncountedLink::send(std::span<const std::uint8_t> frame) {
  const Pause pause;
  return inner_.send(frame);
}

Result<Nanoseconds> UncountedLink::send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) {
  const Pause pause;
  return inner_.send_corrected(frame, field);
}

Result<ReceivedFrame> UncountedLink::receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) {
  const Pause pause;
  return inner_.receive(buffer, deadline);
}

}  // namespace syncline::test
