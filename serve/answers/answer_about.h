/* answer_about.h - the endpoints "about" and "room", which give the version, the lists,
 * and the initial room of the server. For use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_ANSWER_ABOUT_H
#define PP_SERVE_ANSWERS_ANSWER_ABOUT_H

#include "serve/work/task.h"

pp_task_run pp_answer_about, pp_answer_about_room;

#endif
