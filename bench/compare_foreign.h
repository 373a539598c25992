/* compare_foreign.h - mistakes in a room that compare has no switch for: reflectances,
 * dimensions, another sky, points elsewhere. */
#ifndef PP_BENCH_COMPARE_FOREIGN_H
#define PP_BENCH_COMPARE_FOREIGN_H

#include <stdbool.h>

#include "studies/study_room.h"

/* A file's text (malloc); NULL: it can't be read. */
char *pp_foreign_text_of(const char *path);

/* The first room of a text, with its own points. False: it has mistakes, and nothing is
 * made. */
bool pp_foreign_room(struct pp_building **building, struct pp_study_room *study,
                     const char *path, const char *text);

/* The text's room with the mistake that u1 chooses, as large as u2 says (0 to 1 each), at
 * `count` points of the room as it is. Returns its name; NULL: the room has no such part
 * or does not bear the change, and nothing is made. */
const char *pp_foreign_draw(struct pp_building **building, struct pp_study_room *study,
                            const char *path, const char *text,
                            const struct pp_receiver *points, int count, double u1,
                            double u2);

#endif
