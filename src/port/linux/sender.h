/* A thread that carries out one job at a time: the transfer that runs while the next strip is rendered. */
#ifndef FIXCAST_LINUX_SENDER_H
#define FIXCAST_LINUX_SENDER_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

/* Carries a job out, on the thread; returns its error. */
typedef int fc_linux_job(void *context);
/* Called on the thread when a job is done, before wait() returns. */
typedef void fc_linux_job_done(void *context, int error);

typedef struct fc_linux_sender {
  pthread_t thread;
  pthread_mutex_t mutex;
  pthread_cond_t changed;
  fc_linux_job *job; /* not NULL: one is waiting or under way */
  void *job_context;
  fc_linux_job_done *done; /* may be NULL */
  void *done_context;
  int result; /* of the last job, until wait() has told it */
  bool ending;
} fc_linux_sender;

/* 0 or an errno, with nothing to end. */
int fc_linux_sender_begin(fc_linux_sender *sender);
/* Waits for the job under way, then ends the thread. */
void fc_linux_sender_end(fc_linux_sender *sender);

/* Starts a job; none may be under way. */
void fc_linux_sender_start(fc_linux_sender *sender, fc_linux_job *job, void *job_context, fc_linux_job_done *done, void *done_context);
/* Until no job is under way: the error of the last one, told once. */
int fc_linux_sender_wait(fc_linux_sender *sender);

#endif
