/* skylight_indicator_fill.h - fills a skylight indicator
 * (model/results/sheets/skylight_indicator_sheet.h): its marks, and the site of a
 * window.
 *
 * The vertical receiver's Waldram diagram is divided into 8 rows of equal height and 10
 * columns of equal width; a mark stands for the middle of each cell, at
 *
 *     sin phi = (2 j + 1)/10 - 1,    Y(gamma) = (2 i + 1)/16 Y(pi/2)
 *
 * on the plan at the distance cot gamma, so that each is worth 1/80 of the open sky's
 * vertical sky component: 0.495 % of the overcast sky's 39.6 %. After the indicator of
 * [BR209], whose marks are at other positions.
 */
#ifndef PP_METHODS_WALDRAM_SKYLIGHT_INDICATOR_FILL_H
#define PP_METHODS_WALDRAM_SKYLIGHT_INDICATOR_FILL_H

#include "model/base/error.h"
#include "model/results/sheets/skylight_indicator_sheet.h"
#include "model/room/world.h"

/* Fills a sheet without a site. Refuses a sky with azimuth dependence. The caller
 * clears the sheet; empty on failure. */
enum pp_status pp_skylight_indicator_fill_blank(
    struct pp_skylight_indicator_sheet *sheet, const struct pp_sky *sky,
    struct pp_error *err);

/* Fills the sheet for a vertical opening of the world, by its index, under the CIE
 * overcast sky. */
enum pp_status pp_skylight_indicator_fill_site(
    struct pp_skylight_indicator_sheet *sheet, const struct pp_world *world,
    int opening, struct pp_error *err);

#endif
