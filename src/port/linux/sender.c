/* A thread that carries out one job at a time. */
#include "sender.h"

static void *run(void *argument) {
  fc_linux_sender *sender = argument;
  (void)pthread_mutex_lock(&sender->mutex);
  for (;;) {
    int result;
    while (sender->job == NULL && !sender->ending) (void)pthread_cond_wait(&sender->changed, &sender->mutex);
    if (sender->job == NULL) break;
    (void)pthread_mutex_unlock(&sender->mutex);
    result = sender->job(sender->job_context);
    if (sender->done != NULL) sender->done(sender->done_context, result);
    (void)pthread_mutex_lock(&sender->mutex);
    sender->result = result;
    sender->job = NULL;
    (void)pthread_cond_broadcast(&sender->changed);
  }
  (void)pthread_mutex_unlock(&sender->mutex);
  return NULL;
}

int fc_linux_sender_begin(fc_linux_sender *sender) {
  int error = pthread_mutex_init(&sender->mutex, NULL);
  if (error != 0) return error;
  error = pthread_cond_init(&sender->changed, NULL);
  if (error == 0) {
    sender->job = NULL;
    sender->result = 0;
    sender->ending = false;
    error = pthread_create(&sender->thread, NULL, run, sender);
    if (error != 0) (void)pthread_cond_destroy(&sender->changed);
  }
  if (error != 0) (void)pthread_mutex_destroy(&sender->mutex);
  return error;
}

void fc_linux_sender_end(fc_linux_sender *sender) {
  (void)pthread_mutex_lock(&sender->mutex);
  sender->ending = true;
  (void)pthread_cond_broadcast(&sender->changed);
  (void)pthread_mutex_unlock(&sender->mutex);
  (void)pthread_join(sender->thread, NULL);
  (void)pthread_cond_destroy(&sender->changed);
  (void)pthread_mutex_destroy(&sender->mutex);
}

void fc_linux_sender_start(fc_linux_sender *sender, fc_linux_job *job, void *job_context, fc_linux_job_done *done, void *done_context) {
  (void)pthread_mutex_lock(&sender->mutex);
  sender->job_context = job_context;
  sender->done = done;
  sender->done_context = done_context;
  sender->job = job;
  (void)pthread_cond_broadcast(&sender->changed);
  (void)pthread_mutex_unlock(&sender->mutex);
}

int fc_linux_sender_wait(fc_linux_sender *sender) {
  int result;
  (void)pthread_mutex_lock(&sender->mutex);
  while (sender->job != NULL) (void)pthread_cond_wait(&sender->changed, &sender->mutex);
  result = sender->result;
  sender->result = 0;
  (void)pthread_mutex_unlock(&sender->mutex);
  return result;
}
