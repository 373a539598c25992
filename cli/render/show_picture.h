/* show_picture.h - writes a picture in a numeric format, as a PNG, or on a sheet. */
#ifndef PP_CLI_RENDER_SHOW_PICTURE_H
#define PP_CLI_RENDER_SHOW_PICTURE_H

#include <stdio.h>

#include "cli/render/render_choice.h"
#include "model/light/outside_light.h"

/* A picture and the data that describe it. */
struct pp_shown_picture {
    struct pp_picture picture; /* in the units of the quantity (quantity.h) */
    enum pp_quantity quantity;
    struct pp_camera camera;      /* camera of the picture, if it shows a room */
    const struct pp_world *world; /* not owned; NULL: the picture comes from a file */
    const struct pp_outside_light *light; /* light on that world; not owned */
    const int *tags;    /* for each pixel, row by row, the index of the surface shown;
                         * not owned; NULL: unknown */
    double (*marks)[2]; /* positions of cache records, in pixels; not owned */
    int mark_count;
    char view[PP_HDR_VIEW_SIZE]; /* view options, as in the header of a picture file;
                                  * empty: unknown */
    char words[256];             /* description of the view; empty: unknown */
    double external_lux;         /* external illuminance, lx; 0: unknown */
};

/* Reads the picture named by --from-picture. The caller clears the member `picture`. */
enum pp_status pp_show_picture_read(struct pp_shown_picture *shown,
                                    const struct pp_render_choice *choice,
                                    struct pp_error *err);

enum pp_status pp_show_picture(const struct pp_shown_picture *shown,
                               const struct pp_render_choice *choice, const char *path,
                               FILE *out, struct pp_error *err);

/* Writes the picture in a numeric format. The header of the file states view and
 * quantity. */
enum pp_status pp_show_picture_numbers(const struct pp_shown_picture *shown,
                                       const struct pp_number_format *format, FILE *out,
                                       struct pp_error *err);

#endif
