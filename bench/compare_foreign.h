/* compare_foreign.h - mistakes in a room that compare does not list: reflectances,
 * dimensions, another sky, moved points. */
#ifndef PP_BENCH_COMPARE_FOREIGN_H
#define PP_BENCH_COMPARE_FOREIGN_H

#include <stdbool.h>

#include "studies/study_room.h"

/* Text of a file (malloc); NULL if it cannot be read. */
char *pp_foreign_text_of(const char *path);

/* First room of a text, with its own points. False, with nothing made, if it has
 * mistakes. */
bool pp_foreign_room(struct pp_building **building, struct pp_study_room *study,
                     const char *path, const char *text);

/* Makes the text's room with the mistake selected by u1 and of the size u2 (0 to 1
 * each), at `count` points of the unchanged room. Returns its name; NULL, with nothing
 * made, if the room has no such part or the change is not possible. */
const char *pp_foreign_draw(struct pp_building **building, struct pp_study_room *study,
                            const char *path, const char *text,
                            const struct pp_receiver *points, int count, double u1,
                            double u2);

#endif
