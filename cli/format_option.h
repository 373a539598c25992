/* format_option.h - the option --format, for the format of results. */
#ifndef PP_CLI_FORMAT_OPTION_H
#define PP_CLI_FORMAT_OPTION_H

#include "cli/options.h"
#include "reports/parts/format.h"

/* Option lists for struct pp_option_group; the value is stored in an enum pp_format. */
extern const struct pp_option pp_format_option[];       /* text, json or csv */
extern const struct pp_option pp_text_or_json_option[]; /* for results that are not
                                                         * tables */

#endif
