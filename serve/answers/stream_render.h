/* stream_render.h - the endpoint "render", a stream of pictures of increasing quality.
 * For use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_STREAM_RENDER_H
#define PP_SERVE_ANSWERS_STREAM_RENDER_H

#include "serve/work/task.h"

pp_task_run pp_stream_render;

#endif
