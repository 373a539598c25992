/* job_store.h - commands whose results are fetched later, from the folder of --jobs. Inside
 * serve/ only.
 *
 * A job is named by 128 random bits, which only who has begun it knows. Its folder entry
 * NAME.json is its state, NAME.result its result: both outlive the server.
 */
#ifndef PP_SERVE_STORES_JOB_STORE_H
#define PP_SERVE_STORES_JOB_STORE_H

#include "serve/work/task.h"

/* { "command": "report", "room": ..., "options": ... } begins a job: { "job": NAME }. */
pp_task_run pp_job_store_put;

/* State of the job, or its result once it is done. */
pp_task_run pp_job_store_get;

#endif
