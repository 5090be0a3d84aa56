/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* Threads and locks of the system: C11's own are there for neither Windows nor macOS. */
#ifndef HEXCON_BASE_SYSTEM_THREADS_H
#define HEXCON_BASE_SYSTEM_THREADS_H

#include <stdbool.h>

#ifdef _WIN32
#include <windows.h>
typedef SRWLOCK system_lock;
typedef HANDLE system_thread;
#else
#include <pthread.h>
typedef pthread_mutex_t system_lock;
typedef pthread_t system_thread;
#endif

/** What a thread runs; it is there until system_thread_join. */
typedef struct system_task {
  void (*run)(void *user);
  void *user;
} system_task;

bool system_lock_begin(system_lock *lock);
void system_lock_take(system_lock *lock);
void system_lock_give(system_lock *lock);
void system_lock_end(system_lock *lock);

/** Start a thread; false if there can be no more. */
bool system_thread_start(system_thread *thread, system_task *task);
void system_thread_join(system_thread thread);

/** Processors that are there for use; below 1 where nobody knows. */
long system_processors(void);

#endif
