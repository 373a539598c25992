/* stream_trace.h - the endpoint trace: simulated daylight factors as a stream. Inside
 * serve/ only. */
#ifndef PP_SERVE_ANSWERS_STREAM_TRACE_H
#define PP_SERVE_ANSWERS_STREAM_TRACE_H

#include "serve/work/task.h"

pp_task_run pp_stream_trace;

#endif
