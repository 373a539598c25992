/* section_line.h - reference points of a section, for room files without a line of
 * points. */
#ifndef PP_STUDIES_SECTION_LINE_H
#define PP_STUDIES_SECTION_LINE_H

#include <stdbool.h>

#include "model/base/error.h"

#include "studies/study_room.h"

/* True if the receivers lie on one straight horizontal line, at two places or more. */
bool pp_section_line_is_straight(const struct pp_receiver *receivers, int count);

/* Where a section is cut. */
struct pp_section_place {
    enum {
        PP_SECTION_OF_ROOM, /* through the largest opening */
        PP_SECTION_AT_X,    /* along y, at this x of the room */
        PP_SECTION_AT_Y,    /* along x, at this y of the room */
        PP_SECTION_THROUGH, /* through the middle of this opening */
    } kind;
    double at_m;
    char opening[32]; /* its label */
};

/* Reads "x=2.1", "y=3" or the name of an opening. PP_BAD_INPUT: the end of a sentence
 * that begins with "expected". */
enum pp_status pp_section_place_read(struct pp_section_place *place, const char *text,
                                     struct pp_error *err);

/* Replaces the room's receivers by a line of points on the working plane, about every
 * 0.25 m, the first and the last half a step from the ends. For an opening in a wall,
 * the line is perpendicular to the wall, from the opening's centre into the room as far
 * as that is free. For a rooflight, it is perpendicular to the wall of the largest
 * window, or along the longer side of a room without windows. Without openings it is
 * along the longer side through the middle. At a given x or y it is the longest piece
 * in the room. PP_BAD_INPUT if the place is not in the room, or if there is no space
 * for two points. */
enum pp_status pp_section_line(struct pp_study_room *room,
                               const struct pp_section_place *place,
                               struct pp_error *err);

#endif
