/* answer_program.h - the endpoints that run a command of the program: chart, assess,
 * size, availability, report, import. For use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_ANSWER_PROGRAM_H
#define PP_SERVE_ANSWERS_ANSWER_PROGRAM_H

#include "serve/work/task.h"

pp_task_run pp_answer_program, pp_answer_program_import;

#endif
