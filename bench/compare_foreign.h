/* compare_foreign.h - rooms with mistakes that compare does not list as causes: other
 * reflectances or dimensions, another sky, moved points. */
#ifndef PP_BENCH_COMPARE_FOREIGN_H
#define PP_BENCH_COMPARE_FOREIGN_H

#include <stdbool.h>

#include "studies/study_room.h"

/* Text of a file (malloc); NULL if it cannot be read. */
char *pp_foreign_text_of(const char *path);

/* Reads the first room of a text, with its own points. Returns false and creates
 * nothing if the text has errors. */
bool pp_foreign_room(struct pp_building **building, struct pp_study_room *study,
                     const char *path, const char *text);

/* Creates a room from the text with a mistake, at `count` points of the unchanged room.
 * u1 and u2, 0 to 1, select the mistake and its size. Returns the name of the mistake.
 * Returns NULL and creates nothing if the room has no such part or the change is not
 * possible. */
const char *pp_foreign_draw(struct pp_building **building, struct pp_study_room *study,
                            const char *path, const char *text,
                            const struct pp_receiver *points, int count, double u1,
                            double u2);

#endif
