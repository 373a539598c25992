/* show_picture.h - a picture into a file of the format that its name asks for. */
#ifndef PP_CLI_RENDER_SHOW_PICTURE_H
#define PP_CLI_RENDER_SHOW_PICTURE_H

#include <stdio.h>

#include "cli/render/render_choice.h"
#include "model/light/outside_light.h"

/* A picture and what is known about it. */
struct pp_shown_picture {
    struct pp_picture picture; /* in the units of its quantity (quantity.h) */
    enum pp_quantity quantity;
    struct pp_camera camera;      /* of a room's picture; */
    const struct pp_world *world; /* not owned; NULL: the picture comes from a file */
    const struct pp_outside_light *light; /* on that world; not owned */
    const int *tags; /* row by row, which surface each pixel shows; not owned; NULL: not
                      * known */
    double (*marks)[2]; /* places of records, in pixels; not owned */
    int mark_count;
    char view[PP_HDR_VIEW_SIZE]; /* as in a picture's head; empty: not known */
    char words[256];             /* the view in words; empty: not known */
    double external_lux;         /* outside; 0: not known */
};

/* The picture of --from-picture; its own (picture) is the caller's to clear. */
enum pp_status pp_show_picture_read(struct pp_shown_picture *shown,
                                    const struct pp_render_choice *choice,
                                    struct pp_error *err);

enum pp_status pp_show_picture(const struct pp_shown_picture *shown,
                               const struct pp_render_choice *choice, const char *path,
                               FILE *out, struct pp_error *err);

/* The picture as numbers, with its view and quantity in the file's head. */
enum pp_status pp_show_picture_numbers(const struct pp_shown_picture *shown,
                                       const struct pp_number_format *format, FILE *out,
                                       struct pp_error *err);

#endif
