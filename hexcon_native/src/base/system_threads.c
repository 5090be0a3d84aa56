/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "system_threads.h"

#ifdef _WIN32

bool system_lock_begin(system_lock *lock) {
  InitializeSRWLock(lock);
  return true;
}

void system_lock_take(system_lock *lock) {
  AcquireSRWLockExclusive(lock);
}

void system_lock_give(system_lock *lock) {
  ReleaseSRWLockExclusive(lock);
}

void system_lock_end(system_lock *lock) {
  (void)lock;
}

static DWORD WINAPI run_task(void *argument) {
  system_task *task = argument;
  task->run(task->user);
  return 0;
}

bool system_thread_start(system_thread *thread, system_task *task) {
  *thread = CreateThread(NULL, 0, run_task, task, 0, NULL);
  return *thread != NULL;
}

void system_thread_join(system_thread thread) {
  (void)WaitForSingleObject(thread, INFINITE);
  (void)CloseHandle(thread);
}

long system_processors(void) {
  SYSTEM_INFO found;
  GetSystemInfo(&found);
  return (long)found.dwNumberOfProcessors;
}

#else
#include <unistd.h>

bool system_lock_begin(system_lock *lock) {
  return pthread_mutex_init(lock, NULL) == 0;
}

void system_lock_take(system_lock *lock) {
  (void)pthread_mutex_lock(lock);
}

void system_lock_give(system_lock *lock) {
  (void)pthread_mutex_unlock(lock);
}

void system_lock_end(system_lock *lock) {
  (void)pthread_mutex_destroy(lock);
}

static void *run_task(void *argument) {
  system_task *task = argument;
  task->run(task->user);
  return NULL;
}

bool system_thread_start(system_thread *thread, system_task *task) {
  return pthread_create(thread, NULL, run_task, task) == 0;
}

void system_thread_join(system_thread thread) {
  (void)pthread_join(thread, NULL);
}

long system_processors(void) {
  return sysconf(_SC_NPROCESSORS_ONLN);
}

#endif
