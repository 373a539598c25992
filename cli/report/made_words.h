/* made_words.h - the command line that makes a report again. */
#ifndef PP_CLI_REPORT_MADE_WORDS_H
#define PP_CLI_REPORT_MADE_WORDS_H

#include "cli/assess/assess_run.h"

/* All that bears on the figures: what is judged, of which files and rooms, how it is
 * simulated; as a shell takes it. To be freed; NULL when memory is out. */
char *pp_made_words(const struct pp_assess_run *run);

#endif
