/* job_store.h - jobs: commands whose results are fetched later. Jobs are stored in the
 * folder of --jobs. For use inside serve/ only.
 *
 * The name of a job consists of 124 random bits, known only to the client that began
 * the job. NAME.json contains the state of the job, NAME.result its result. Both files
 * remain after the server has stopped.
 */
#ifndef PP_SERVE_STORES_JOB_STORE_H
#define PP_SERVE_STORES_JOB_STORE_H

#include "serve/work/task.h"

/* Begins a job: { "command": "report", "room": ..., "options": ... }. Answers with {
 * "job": NAME }. */
pp_task_run pp_job_store_put;

/* Answers with the result of the job if it has succeeded, else with its state. */
pp_task_run pp_job_store_get;

#endif
