/* make_picture.h - renders a picture of a room, shows a progress bar, writes
 * checkpoints, and handles interrupts. */
#ifndef PP_CLI_RENDER_MAKE_PICTURE_H
#define PP_CLI_RENDER_MAKE_PICTURE_H

#include "cli/render/render_choice.h"
#include "cli/render/show_picture.h"
#include "model/light/outside_light.h"

struct pp_made_picture {
    struct pp_shown_picture shown;
    struct pp_picture errors; /* standard errors of the pixels; empty if not
                               * requested */
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_opening_store *store;
    struct pp_irradiance_cache *cache; /* NULL: light paths are traced without a
                                        * cache */
    struct pp_render *render;
    double (*marks)[2];
};

/* Makes a picture. PP_INTERRUPTED: the user interrupted and there is no picture; the
 * message lists the files that were saved. The caller clears *made, whatever the
 * status. */
enum pp_status pp_make_picture(struct pp_made_picture *made,
                               const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_render_choice *choice,
                               const struct pp_room_options *options,
                               struct pp_error *err);
void pp_make_picture_clear(struct pp_made_picture *made);

#endif
