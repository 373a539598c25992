/* nomogram_notes.h - the words on a nomogram: its purpose, its use, and the
 * readings. */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_NOTES_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_NOTES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/nomogram_sheet.h"

/* Label above a stem: "W/A". Static. */
const char *pp_nomogram_notes_stem_label(const struct pp_nomogram *nomogram, int stem);

/* Append to a text of `room` bytes as pp_page_say does; the text begins empty. */
void pp_nomogram_notes_title(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet);
void pp_nomogram_notes_subtitle(char *text, size_t room,
                                const struct pp_nomogram_sheet *sheet);
void pp_nomogram_notes_instructions(char *text, size_t room,
                                    const struct pp_nomogram *nomogram);
void pp_nomogram_notes_foot(char *text, size_t room,
                            const struct pp_nomogram_sheet *sheet);

/* A window's reading on a stem, "1.34", preceded by the window's number if there are
 * several windows and the reading is not for the whole room. briefly: that number
 * alone. */
void pp_nomogram_notes_value(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet, int window,
                             int stem, bool briefly);

#endif
