/* print.h - parts that all text reports have in common: the title of a room, the facts
 * assumed for it, and wrapped sentences. */
#ifndef PP_REPORTS_PARTS_PRINT_H
#define PP_REPORTS_PARTS_PRINT_H

#include <stdio.h>

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Prints the room's name and its file on one line. */
void pp_print_title(const struct pp_world *world, const char *file, FILE *out);

/* Prints the assumptions for the room (sky, working plane, surfaces, glass), one per
 * line, as the first part of a report. */
void pp_print_assumed(const struct pp_world *world,
                      const struct pp_outside_light *light, int width, FILE *out);

/* Callback that receives one fact: label "room", text "5.00 x 4.50 m, ...". */
typedef void pp_print_fact(void *closure, const char *label, const char *text);

/* Passes the facts to `fact`, one by one. */
void pp_print_facts(const struct pp_world *world, const struct pp_outside_light *light,
                    pp_print_fact *fact, void *closure);

/* Prints text that starts in column `column`, wrapped at `width`. Further lines are
 * indented by `indent`. Ends the line. */
void pp_print_wrapped(const char *text, int column, int indent, int width, FILE *out);

#endif
