/* section_line.h - reference points of a section, for room files without a line of
 * points. */
#ifndef PP_STUDIES_SECTION_LINE_H
#define PP_STUDIES_SECTION_LINE_H

#include <stdbool.h>

#include "studies/study_room.h"

/* True if the receivers lie on one straight horizontal line, at two places or more. */
bool pp_section_line_is_straight(const struct pp_receiver *receivers, int count);

/* Replaces the room's receivers by a line of points: on the working plane, square to
 * the wall of the largest window, from its centre into the room as far as that is free,
 * about every 0.25 m, half a step from both ends. A room without windows gets the line
 * along its longer side through the middle. PP_BAD_INPUT if there is no space for two
 * points. */
enum pp_status pp_section_line(struct pp_study_room *room, struct pp_error *err);

#endif
