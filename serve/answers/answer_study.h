/* answer_study.h - the endpoints that call the library directly: df, plan, check. For
 * use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_ANSWER_STUDY_H
#define PP_SERVE_ANSWERS_ANSWER_STUDY_H

#include "serve/work/task.h"

pp_task_run pp_answer_study_df, pp_answer_study_plan, pp_answer_study_check;

#endif
