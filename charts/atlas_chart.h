/* atlas_chart.h - maps of a method's error over the rooms of an atlas.
 *
 * A map by one feature divides the rooms into classes. For each class it shows the
 * median ratio of the method's value to the simulated value, with whiskers that contain
 * 90 % of the rooms. A second bar shows the ratio for rooms simplified to the method's
 * assumptions, which is the error of the formula alone. The vertical scale is
 * logarithmic, so that double and half are equal errors.
 *
 * A map by two features has a cell for each pair of classes. The cell is grey where the
 * method is too high and hatched where it is too low; a larger error is darker or
 * denser. The cell states the median and, in small type, the number of rooms.
 */
#ifndef PP_CHARTS_ATLAS_CHART_H
#define PP_CHARTS_ATLAS_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/atlas_map.h"

enum pp_status pp_atlas_chart_draw(struct pp_canvas *canvas,
                                   const struct pp_atlas_map *map,
                                   struct pp_error *err);

#endif
