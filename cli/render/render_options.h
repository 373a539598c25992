/* render_options.h - option tables of the command render. */
#ifndef PP_CLI_RENDER_RENDER_OPTIONS_H
#define PP_CLI_RENDER_RENDER_OPTIONS_H

#include "cli/options.h"
#include "cli/render/render_choice.h"

/* Lists for struct pp_option_group; the values are stored in a struct
 * pp_render_choice. */
extern const struct pp_option pp_render_view_options[];
extern const struct pp_option pp_render_picture_options[];
extern const struct pp_option pp_render_shown_options[];

#endif
