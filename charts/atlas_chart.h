/* atlas_chart.h - maps of a method's error over the rooms of an atlas.
 *
 * By one number: in each class the median of what the method says over what is true, with
 * whiskers over 90 % of the rooms; beside it the same in the world that the method
 * calculates in, whose whiskers are the formula's error alone. Up is a logarithmic scale,
 * since twice and half as much are alike.
 *
 * By two numbers: a field for each pair of classes, grey where the method says too much,
 * hatched where it says too little, both the denser the further off; the median stands in
 * it. Number of rooms in small figures.
 */
#ifndef PP_CHARTS_ATLAS_CHART_H
#define PP_CHARTS_ATLAS_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/atlas_map.h"

enum pp_status pp_atlas_chart_draw(struct pp_canvas *canvas,
                                   const struct pp_atlas_map *map,
                                   struct pp_error *err);

#endif
