/* stream_annual.h - the endpoint "annual", a stream of results for a year. For use
 * inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_STREAM_ANNUAL_H
#define PP_SERVE_ANSWERS_STREAM_ANNUAL_H

#include "serve/work/task.h"

pp_task_run pp_stream_annual;

#endif
