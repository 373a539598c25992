/* show_picture.h - writes a picture in a numeric format, as PNG, or on a sheet. */
#ifndef PP_CLI_RENDER_SHOW_PICTURE_H
#define PP_CLI_RENDER_SHOW_PICTURE_H

#include <stdio.h>

#include "cli/render/render_choice.h"
#include "model/light/outside_light.h"

/* A picture and its metadata. */
struct pp_shown_picture {
    struct pp_picture picture; /* in the units of its quantity (quantity.h) */
    enum pp_quantity quantity;
    struct pp_camera camera;      /* camera of a room's picture */
    const struct pp_world *world; /* not owned; NULL: the picture comes from a file */
    const struct pp_outside_light *light; /* light on that world; not owned */
    const int *tags;    /* index of the surface that each pixel shows, row by row; not
                         * owned; NULL: unknown */
    double (*marks)[2]; /* positions of cache records, in pixels; not owned */
    int mark_count;
    char view[PP_HDR_VIEW_SIZE]; /* view options as in the header of a picture file;
                                  * empty: unknown */
    char words[256];             /* description of the view; empty: unknown */
    double external_lux;         /* illuminance outside, lx; 0: unknown */
};

/* Reads the picture of --from-picture; the caller clears its `picture`. */
enum pp_status pp_show_picture_read(struct pp_shown_picture *shown,
                                    const struct pp_render_choice *choice,
                                    struct pp_error *err);

enum pp_status pp_show_picture(const struct pp_shown_picture *shown,
                               const struct pp_render_choice *choice, const char *path,
                               FILE *out, struct pp_error *err);

/* Writes the picture in a numeric format, with its view and quantity in the file's
 * header. */
enum pp_status pp_show_picture_numbers(const struct pp_shown_picture *shown,
                                       const struct pp_number_format *format, FILE *out,
                                       struct pp_error *err);

#endif
