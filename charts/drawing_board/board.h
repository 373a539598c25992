/* board.h - shared parts of the drawing-board diagrams: pieces of windows, the sum
 * written below them, a ruler. */
#ifndef PP_CHARTS_DRAWING_BOARD_BOARD_H
#define PP_CHARTS_DRAWING_BOARD_BOARD_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/results/board_sheets.h"

/* Map from a diagram's own coordinates to paper: x0 + mm x, y0 - mm y. */
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

/* Tints the visible parts of windows as sky or, darker and hatched, as obstruction;
 * `within` bounds the hatching, mm on paper. */
void pp_board_tints(cairo_t *cr, const struct pp_style *style,
                    const struct pp_board_map *map,
                    const struct pp_board_window *windows, int count,
                    struct pp_box within);

/* Draws the outline of a region. */
void pp_board_outline(cairo_t *cr, const struct pp_style *style,
                      const struct pp_board_map *map, const struct pp_region *region);

/* Draws a sample of the sky's tint and, if hidden_too, one of the obstructions', each
 * with its word, from x, y on; only measures unless `drawn`. Returns the box. */
struct pp_box pp_board_tint_keys(cairo_t *cr, const struct pp_style *style, double x,
                                 double y, bool hidden_too, bool drawn);

/* Begins the text above a panel: the wall or ceiling, and its glass. */
void pp_board_panel_words(char *words, size_t room, const struct pp_board_face *face,
                          bool glazed);

/* Sums written below a diagram: one line with letter and sum for each of the first few
 * windows, the number of other windows, and the total. */
struct pp_board_sums {
    const char *unit; /* "squares" */
    bool upright;     /* for the outside of a wall: the sum is the vertical sky
                       * component */
    double worth;     /* value of one unit, a fraction of Eh */
    bool any_hidden;
    double sky, external;
    int windows;
    char text[4096];
};

/* Adds the windows of a panel. */
void pp_board_sums_add(struct pp_board_sums *sums,
                       const struct pp_board_window *windows, int count);

/* Draws the sums, wrapped to `width`, with their upper left corner at x, y; only
 * measures them if not `drawn`. Returns their height. */
double pp_board_sums_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_board_sums *sums, double x, double y,
                          double width, bool drawn);

/* "A", "B" ... of window number `index`. */
const char *pp_board_letter(int index);

/* A ruler of 100 mm with centimetres and millimetres, its left end at x, y its upper
 * edge, and the note "print at 100 %". Returns its box. */
struct pp_box pp_board_ruler(cairo_t *cr, const struct pp_style *style, double x,
                             double y);

/* Height of the ruler. */
double pp_board_ruler_height(const struct pp_style *style);

#endif
