/* stream_trace.h - the endpoint "trace", a stream of simulated daylight factors. For
 * use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_STREAM_TRACE_H
#define PP_SERVE_ANSWERS_STREAM_TRACE_H

#include "serve/work/task.h"

pp_task_run pp_stream_trace;

#endif
