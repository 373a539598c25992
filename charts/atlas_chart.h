/* atlas_chart.h - maps of a method's error over the rooms of an atlas.
 *
 * Maps by one number show for each class the median ratio of the method's value to the
 * simulated one, with whiskers over 90 % of the rooms. Next to it is the ratio in the
 * method's own world, whose whiskers show the formula's error alone. The vertical scale
 * is logarithmic, since twice and half as much are equal errors.
 *
 * Maps by two numbers have a field for each pair of classes: grey where the method is
 * too high, hatched where it is too low, denser with the error. The median is printed
 * in the field, the number of rooms in small figures.
 */
#ifndef PP_CHARTS_ATLAS_CHART_H
#define PP_CHARTS_ATLAS_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/atlas_map.h"

enum pp_status pp_atlas_chart_draw(struct pp_canvas *canvas,
                                   const struct pp_atlas_map *map,
                                   struct pp_error *err);

#endif
