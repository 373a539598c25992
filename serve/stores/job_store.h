/* job_store.h - commands whose results are fetched later, from the folder of --jobs.
 * Inside serve/ only.
 *
 * The name of a job is 124 random bits, known only to the client that began it.
 * NAME.json is its state, NAME.result its result; both remain after the server has
 * stopped.
 */
#ifndef PP_SERVE_STORES_JOB_STORE_H
#define PP_SERVE_STORES_JOB_STORE_H

#include "serve/work/task.h"

/* Begins a job: { "command": "report", "room": ..., "options": ... }. Answers with {
 * "job": NAME }. */
pp_task_run pp_job_store_put;

/* Answers with the state of the job or, once it is done, with its result. */
pp_task_run pp_job_store_get;

#endif
