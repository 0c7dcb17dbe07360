// What the linker puts in the place of clocks, sleeps, threads and locks in the node (ld --wrap), over simulated time.
#include <errno.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/time.h>
#include <time.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "kernel.hpp"

using sitaf_ros::EPOCH;
using sitaf_ros::Nanos;
using sitaf_ros::SECOND;
namespace kernel = sitaf_ros::kernel;

namespace {

timespec spec(Nanos time) {return {static_cast<time_t>(time / SECOND), static_cast<long>(time % SECOND)};}
Nanos nanos(const timespec & time) {return time.tv_sec * SECOND + time.tv_nsec;}

// The library's mutex in place of the system's, of the same size and with the same initial value of zeros. The kind
// has the place that the static initializers of glibc give it.
struct Mutex
{
  int count;
  int unused;
  std::uint64_t owner;
  int kind;
};
static_assert(sizeof(Mutex) <= sizeof(pthread_mutex_t));

Mutex & of(pthread_mutex_t * mutex) {return *reinterpret_cast<Mutex *>(mutex);}

int acquire(pthread_mutex_t * mutex, std::optional<Nanos> deadline)
{
  Mutex & m = of(mutex);
  const std::uint64_t me = kernel::current_number() + 1;
  while (m.count > 0 && m.owner != me) {
    if (!kernel::in_fiber()) {
      return EDEADLK;
    }
    if (!kernel::wait(mutex, deadline) && deadline && kernel::now() >= *deadline) {
      return ETIMEDOUT;
    }
  }
  if (m.count > 0 && (m.kind & 3) != PTHREAD_MUTEX_RECURSIVE) {
    if ((m.kind & 3) == PTHREAD_MUTEX_ERRORCHECK) {
      return EDEADLK;
    }
    kernel::wait(nullptr, std::nullopt);  // a deadlock, to the end of the case
  }
  m.owner = me;
  ++m.count;
  return 0;
}

int release(pthread_mutex_t * mutex)
{
  Mutex & m = of(mutex);
  if (m.count > 0 && --m.count == 0) {
    kernel::wake(mutex, false);
  }
  return 0;
}

int wait_for(pthread_cond_t * condition, pthread_mutex_t * mutex, std::optional<Nanos> deadline)
{
  release(mutex);
  const bool woken = kernel::wait(condition, deadline);
  acquire(mutex, std::nullopt);
  return woken ? 0 : ETIMEDOUT;
}

struct Shared
{
  int readers;
  std::uint64_t writer;
};

Shared & of(pthread_rwlock_t * lock) {return *reinterpret_cast<Shared *>(lock);}

int wait_on_futex(unsigned * address, unsigned value, bool has_timeout, Nanos until)
{
  if (*address != value) {
    return 1;
  }
  return kernel::wait(address, has_timeout ? std::optional<Nanos>(until - EPOCH) : std::nullopt) ? 1 : 0;
}

}  // namespace

extern "C" {

int __wrap_clock_gettime(clockid_t, timespec * time) {*time = spec(kernel::look()); return 0;}
int __wrap_gettimeofday(timeval * time, void *)
{
  const Nanos now = kernel::look();
  time->tv_sec = now / SECOND;
  time->tv_usec = now % SECOND / 1000;
  return 0;
}
time_t __wrap_time(time_t * time)
{
  const time_t now = kernel::look() / SECOND;
  if (time != nullptr) {
    *time = now;
  }
  return now;
}
clock_t __wrap_clock() {return (kernel::look() - EPOCH) / 1000;}
std::int64_t __wrap__ZNSt6chrono3_V212steady_clock3nowEv() {return kernel::look();}
std::int64_t __wrap__ZNSt6chrono3_V212system_clock3nowEv() {return kernel::look();}

int __wrap_nanosleep(const timespec * time, timespec *)
{
  kernel::sleep_until(kernel::now() + nanos(*time));
  return 0;
}
int __wrap_clock_nanosleep(clockid_t, int flags, const timespec * time, timespec *)
{
  kernel::sleep_until((flags & TIMER_ABSTIME) != 0 ? nanos(*time) - EPOCH : kernel::now() + nanos(*time));
  return 0;
}
int __wrap_usleep(unsigned micros) {kernel::sleep_until(kernel::now() + Nanos{micros} * 1000); return 0;}
unsigned __wrap_sleep(unsigned seconds) {kernel::sleep_until(kernel::now() + seconds * SECOND); return 0;}
void __wrap__ZNSt11this_thread11__sleep_forENSt6chrono8durationIlSt5ratioILl1ELl1EEEENS1_IlS2_ILl1ELl1000000000EEEE(
  std::int64_t seconds, std::int64_t rest)
{
  kernel::sleep_until(kernel::now() + seconds * SECOND + rest);
}
int __wrap_sched_yield() {kernel::wait(nullptr, kernel::now()); kernel::look(); return 0;}

pthread_t __wrap_pthread_self() {return kernel::current_number() + 1;}
int __wrap_pthread_equal(pthread_t a, pthread_t b) {return a == b;}

void __wrap__ZNSt6thread15_M_start_threadESt10unique_ptrINS_6_StateESt14default_deleteIS1_EEPFvvE(
  std::thread * thread, std::unique_ptr<std::thread::_State> * state, void (*)())
{
  std::shared_ptr<std::thread::_State> run(std::move(*state));
  const std::uint64_t number = kernel::start("a thread of the node", [run] {run->_M_run();});
  *reinterpret_cast<pthread_t *>(thread) = number + 1;
}
void __wrap__ZNSt6thread4joinEv(std::thread * thread)
{
  auto & id = *reinterpret_cast<pthread_t *>(thread);
  if (id == 0) {
    throw std::system_error(std::make_error_code(std::errc::invalid_argument), "not joinable");
  }
  kernel::join(id - 1);
  id = 0;
}
void __wrap__ZNSt6thread6detachEv(std::thread * thread) {*reinterpret_cast<pthread_t *>(thread) = 0;}
unsigned __wrap__ZNSt6thread20hardware_concurrencyEv() {return 8;}
int __wrap_pthread_create(pthread_t * thread, const pthread_attr_t *, void * (*run)(void *), void * argument)
{
  *thread = kernel::start("a thread of the node", [run, argument] {run(argument);}) + 1;
  return 0;
}
int __wrap_pthread_join(pthread_t thread, void **) {kernel::join(thread - 1); return 0;}
int __wrap_pthread_detach(pthread_t) {return 0;}
int __wrap_pthread_setschedparam(pthread_t, int, const sched_param *) {return EPERM;}
int __wrap_pthread_getschedparam(pthread_t, int * policy, sched_param * parameter)
{
  *policy = SCHED_OTHER;
  parameter->sched_priority = 0;
  return 0;
}
int __wrap_pthread_setaffinity_np(pthread_t, size_t, const void *) {return 0;}
int __wrap_pthread_setname_np(pthread_t, const char *) {return 0;}

int __wrap_pthread_mutex_init(pthread_mutex_t * mutex, const pthread_mutexattr_t * attributes)
{
  of(mutex) = Mutex{};
  int kind = PTHREAD_MUTEX_NORMAL;
  if (attributes != nullptr) {
    pthread_mutexattr_gettype(attributes, &kind);
  }
  of(mutex).kind = kind;
  return 0;
}
int __wrap_pthread_mutex_destroy(pthread_mutex_t *) {return 0;}
int __wrap_pthread_mutex_lock(pthread_mutex_t * mutex) {return acquire(mutex, std::nullopt);}
int __wrap_pthread_mutex_trylock(pthread_mutex_t * mutex)
{
  const Mutex & m = of(mutex);
  const bool own = m.owner == kernel::current_number() + 1;
  if (m.count > 0 && !(own && (m.kind & 3) == PTHREAD_MUTEX_RECURSIVE)) {
    kernel::look();
    return EBUSY;
  }
  return acquire(mutex, std::nullopt);
}
int __wrap_pthread_mutex_timedlock(pthread_mutex_t * mutex, const timespec * until)
{
  return acquire(mutex, nanos(*until) - EPOCH);
}
int __wrap_pthread_mutex_clocklock(pthread_mutex_t * mutex, clockid_t, const timespec * until)
{
  return acquire(mutex, nanos(*until) - EPOCH);
}
int __wrap_pthread_mutex_unlock(pthread_mutex_t * mutex) {return release(mutex);}

int __wrap_pthread_cond_wait(pthread_cond_t * condition, pthread_mutex_t * mutex)
{
  return wait_for(condition, mutex, std::nullopt);
}
int __wrap_pthread_cond_timedwait(pthread_cond_t * condition, pthread_mutex_t * mutex, const timespec * until)
{
  return wait_for(condition, mutex, nanos(*until) - EPOCH);
}
int __wrap_pthread_cond_clockwait(
  pthread_cond_t * condition, pthread_mutex_t * mutex, clockid_t, const timespec * until)
{
  return wait_for(condition, mutex, nanos(*until) - EPOCH);
}
int __wrap_pthread_cond_signal(pthread_cond_t * condition) {kernel::wake(condition, false); return 0;}
int __wrap_pthread_cond_broadcast(pthread_cond_t * condition) {kernel::wake(condition); return 0;}
void __wrap__ZNSt18condition_variable4waitERSt11unique_lockISt5mutexE(
  void * condition, std::unique_lock<std::mutex> & held)
{
  wait_for(static_cast<pthread_cond_t *>(condition), held.mutex()->native_handle(), std::nullopt);
}
void __wrap__ZNSt18condition_variable10notify_oneEv(void * condition) {kernel::wake(condition, false);}
void __wrap__ZNSt18condition_variable10notify_allEv(void * condition) {kernel::wake(condition);}

int __wrap_pthread_rwlock_rdlock(pthread_rwlock_t * lock)
{
  while (of(lock).writer != 0) {
    kernel::wait(lock, std::nullopt);
  }
  ++of(lock).readers;
  return 0;
}
int __wrap_pthread_rwlock_wrlock(pthread_rwlock_t * lock)
{
  while (of(lock).writer != 0 || of(lock).readers > 0) {
    kernel::wait(lock, std::nullopt);
  }
  of(lock).writer = kernel::current_number() + 1;
  return 0;
}
int __wrap_pthread_rwlock_tryrdlock(pthread_rwlock_t * lock)
{
  return of(lock).writer != 0 ? EBUSY : __wrap_pthread_rwlock_rdlock(lock);
}
int __wrap_pthread_rwlock_trywrlock(pthread_rwlock_t * lock)
{
  return of(lock).writer != 0 || of(lock).readers > 0 ? EBUSY : __wrap_pthread_rwlock_wrlock(lock);
}
int __wrap_pthread_rwlock_unlock(pthread_rwlock_t * lock)
{
  if (of(lock).writer != 0) {
    of(lock).writer = 0;
  } else {
    --of(lock).readers;
  }
  kernel::wake(lock);
  return 0;
}

// The waits of std::future and std::promise.
bool __wrap__ZNSt28__atomic_futex_unsigned_base19_M_futex_wait_untilEPjjbNSt6chrono8durationIlSt5ratioILl1ELl1EEEENS2_IlS3_ILl1ELl1000000000EEEE(
  void *, unsigned * address, unsigned value, bool has_timeout, std::int64_t seconds, std::int64_t rest)
{
  return wait_on_futex(address, value, has_timeout, seconds * SECOND + rest) != 0;
}
bool __wrap__ZNSt28__atomic_futex_unsigned_base26_M_futex_wait_until_steadyEPjjbNSt6chrono8durationIlSt5ratioILl1ELl1EEEENS2_IlS3_ILl1ELl1000000000EEEE(
  void *, unsigned * address, unsigned value, bool has_timeout, std::int64_t seconds, std::int64_t rest)
{
  return wait_on_futex(address, value, has_timeout, seconds * SECOND + rest) != 0;
}
void __wrap__ZNSt28__atomic_futex_unsigned_base19_M_futex_notify_allEPj(unsigned * address) {kernel::wake(address);}

}  // extern "C"
