/* nomogram_notes.h - the text on a nomogram: purpose, instructions, and readings. */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_NOTES_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_NOTES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/nomogram_sheet.h"

/* Label above a stem, such as "W/A". Static string. */
const char *pp_nomogram_notes_stem_label(const struct pp_nomogram *nomogram, int stem);

/* Functions that write text into a buffer of `room` bytes. */
void pp_nomogram_notes_title(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet);
void pp_nomogram_notes_subtitle(char *text, size_t room,
                                const struct pp_nomogram_sheet *sheet);
void pp_nomogram_notes_instructions(char *text, size_t room,
                                    const struct pp_nomogram *nomogram);
void pp_nomogram_notes_foot(char *text, size_t room,
                            const struct pp_nomogram_sheet *sheet);

/* A window's reading on a stem, "1.34". If there are several windows and the reading is
 * not for the whole room, the window's number comes first. briefly: in that case, only
 * the window's number is written. */
void pp_nomogram_notes_value(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet, int window,
                             int stem, bool briefly);

#endif
