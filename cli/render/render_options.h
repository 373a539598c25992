/* render_options.h - the options of the command render, as they are typed. */
#ifndef PP_CLI_RENDER_RENDER_OPTIONS_H
#define PP_CLI_RENDER_RENDER_OPTIONS_H

#include "cli/options.h"
#include "cli/render/render_choice.h"

/* Lists for struct pp_option_group, with a struct pp_render_choice as values. */
extern const struct pp_option pp_render_view_options[];
extern const struct pp_option pp_render_picture_options[];
extern const struct pp_option pp_render_shown_options[];

#endif
