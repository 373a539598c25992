/* trees_note.h - the note that criteria of an assessment do not consider trees
 * (trees_left_out.h). It describes the room from whose windows a crown appears
 * highest. */
#ifndef PP_REPORTS_ASSESS_TREES_NOTE_H
#define PP_REPORTS_ASSESS_TREES_NOTE_H

#include <stddef.h>

#include <json-c/json.h>

#include "studies/criteria/assessment.h"

enum { PP_TREES_NOTE_BYTES = 2048 };

/* Writes the note on one or more rooms; false if there is none. degree: the sign or word
 * after a number of degrees. */
bool pp_trees_note_text(char text[PP_TREES_NOTE_BYTES],
                        const struct pp_assessment *rooms, int count,
                        const char *degree);

/* Adds "trees_left_out": { "criteria": ["vertical-sky"], "room": "Study", "line": 3,
 * "altitude": 62, "of": "W1, south" } to the object if there is a note, with the room if
 * there are several; false if the memory is exhausted. */
bool pp_trees_note_json(struct json_object *object, const struct pp_assessment *rooms,
                        int count);

#endif
