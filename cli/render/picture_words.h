/* picture_words.h - what a sheet says of a picture, and its false colours. */
#ifndef PP_CLI_RENDER_PICTURE_WORDS_H
#define PP_CLI_RENDER_PICTURE_WORDS_H

#include "cli/render/show_picture.h"
#include "model/results/sheets/picture_sheet.h"

/* Title, subtitle and notes; the scale of lengths. */
void pp_picture_words(struct pp_picture_sheet *sheet,
                      const struct pp_shown_picture *shown,
                      const struct pp_render_choice *choice);

/* Raster, scale and level lines. */
enum pp_status pp_picture_words_false_colour(struct pp_picture_sheet *sheet,
                                             const struct pp_shown_picture *shown,
                                             const struct pp_render_choice *choice,
                                             struct pp_error *err);

#endif
