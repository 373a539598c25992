/* section_line.h - makes reference points for a section, if the room file does not have
 * a line of points. */
#ifndef PP_STUDIES_SECTION_LINE_H
#define PP_STUDIES_SECTION_LINE_H

#include <stdbool.h>

#include "model/base/error.h"

#include "studies/study_room.h"

/* True if the receivers are on one straight horizontal line, and the last one is not
 * where the first one is. */
bool pp_section_line_is_straight(const struct pp_receiver *receivers, int count);

/* Position of a section. */
struct pp_section_place {
    enum {
        PP_SECTION_OF_ROOM, /* through the largest opening */
        PP_SECTION_AT_X,    /* parallel to the y axis, at this x */
        PP_SECTION_AT_Y,    /* parallel to the x axis, at this y */
        PP_SECTION_THROUGH, /* through the middle of this opening */
    } kind;
    double at_m;
    char opening[32]; /* label of that opening */
};

/* Reads "x=2.1", "y=3" or the name of an opening. PP_BAD_INPUT: the message is the end
 * of a sentence that begins with "expected". */
enum pp_status pp_section_place_read(struct pp_section_place *place, const char *text,
                                     struct pp_error *err);

/* Replaces the room's receivers by a line of points on the working plane, about 0.25 m
 * apart; the first and last points are half that distance from the ends. For an opening
 * in a wall, the line is perpendicular to the wall, from the centre of the opening into
 * the room until it leaves the room. For a rooflight, the line is perpendicular to the
 * wall of the largest window, or along the longer side of a room without windows.
 * Without openings, the line is along the longer side, through the middle of the room.
 * At a given x or y, the line is the longest part within the room. PP_BAD_INPUT if the
 * position is not in the room, if no opening has that name, or if there is no space for
 * two points. */
enum pp_status pp_section_line(struct pp_study_room *room,
                               const struct pp_section_place *place,
                               struct pp_error *err);

#endif
