/* slat_sheet.h - the light through a blind by profile angle, as drawn.
 *
 * charts/slats_chart.h draws it. Light is relative to the light that falls on the plane
 * of the blind; angles are in degrees, profile angles greater than 0 for light that
 * travels downwards into the room.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_SLAT_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_SLAT_SHEET_H

#include "model/light/slats/slat_cell.h"
#include "model/light/slats/window_device.h"

enum { PP_SLAT_SHEET_CURVE = 169, PP_SLAT_SHEET_ROWS = 16 };

struct pp_slat_sheet {
    const char *title; /* not owned */
    struct pp_window_device device;
    /* Profile angles from -84 to 84 degrees by 1. */
    struct pp_slat_parts curve[PP_SLAT_SHEET_CURVE];
    /* Profile angles of -75 to 75 degrees by 15; then uniform light from the whole
     * outside, from its upper half (sky) and from its lower half (ground). */
    int row_count;
    struct {
        char words[24];
        struct pp_slat_parts parts;
    } rows[PP_SLAT_SHEET_ROWS];
};

#endif
