/* board.h - parts shared by the drawing-board diagrams: the pieces of windows, the sum
 * below a diagram, and a ruler. */
#ifndef PP_CHARTS_DRAWING_BOARD_BOARD_H
#define PP_CHARTS_DRAWING_BOARD_BOARD_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/results/board_sheets.h"

/* Map from the coordinates of a diagram to paper (mm): x0 + mm x, y0 - mm y. */
struct pp_board_map {
    double x0, y0, mm;
};

static inline double pp_board_x(const struct pp_board_map *map, double x)
{
    return map->x0 + map->mm * x;
}

static inline double pp_board_y(const struct pp_board_map *map, double y)
{
    return map->y0 - map->mm * y;
}

/* Tints the visible parts of windows: sky lightly, obstructions darker and with
 * hatching. `within` limits the hatching (mm on paper). */
void pp_board_tints(cairo_t *cr, const struct pp_style *style,
                    const struct pp_board_map *map,
                    const struct pp_board_window *windows, int count,
                    struct pp_box within);

/* Strokes the outline of a region. */
void pp_board_outline(cairo_t *cr, const struct pp_style *style,
                      const struct pp_board_map *map, const struct pp_region *region);

/* Draws a sample of the tint of the sky and, if hidden_too, of obstructions, each with
 * its name. x, y: upper left corner. If `drawn` is false, only measures. Returns the
 * box. */
struct pp_box pp_board_tint_keys(cairo_t *cr, const struct pp_style *style, double x,
                                 double y, bool hidden_too, bool drawn);

/* Begins the text above a panel, with the wall or ceiling and its glass. */
void pp_board_panel_words(char *words, size_t room, const struct pp_board_face *face,
                          bool glazed);

/* Sums written below a diagram. Each of the first few windows has a line with its
 * letter and sum. The number of other windows and the total follow. */
struct pp_board_sums {
    const char *unit; /* name of the unit, such as "squares" */
    bool upright;     /* the diagram is for the outside of a wall, so that the sum is
                       * the vertical sky component */
    double worth;     /* value of one unit, as a fraction of the illuminance under the
                       * open sky */
    bool any_hidden;
    double sky, external;
    int windows;
    char text[4096];
};

/* Adds the windows of a panel to the sums. */
void pp_board_sums_add(struct pp_board_sums *sums,
                       const struct pp_board_window *windows, int count);

/* Draws the sums, wrapped to `width`, with their upper left corner at x, y. If `drawn`
 * is false, only measures. Returns the height. */
double pp_board_sums_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_board_sums *sums, double x, double y,
                          double width, bool drawn);

/* Letter of the window with this index: "A", "B" ... */
const char *pp_board_letter(int index);

/* Draws a ruler of 100 mm with centimetres and millimetres, and the note "print at 100
 * %". x, y: left end of the upper edge. Returns the box. */
struct pp_box pp_board_ruler(cairo_t *cr, const struct pp_style *style, double x,
                             double y);

/* Height of the ruler with its note, in mm. */
double pp_board_ruler_height(const struct pp_style *style);

#endif
