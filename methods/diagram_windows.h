/* diagram_windows.h - assigns the windows of a room to the diagrams of a graphical
 * method, and begins the entry of a window on its diagram.
 *
 * Windows share a diagram if they face the same way and are all glazed or all unglazed.
 */
#ifndef PP_METHODS_DIAGRAM_WINDOWS_H
#define PP_METHODS_DIAGRAM_WINDOWS_H

#include "methods/method.h"
#include "methods/view/window_drawing.h"
#include "model/light/outside_light.h"
#include "model/results/board_sheets.h"

/* PP_OK if the method covers the room and all its openings for the receiver; else
 * PP_BAD_INPUT with the reason. */
enum pp_status pp_diagram_windows_check(const struct pp_method *method,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_receiver *receiver,
                                        struct pp_error *err);

/* The index of the first opening that shares a diagram with opening `index`, which may
 * be `index` itself. */
int pp_diagram_windows_first_alike(const struct pp_world *world, int index);

/* Number of openings on the diagram whose first opening is `first`. */
int pp_diagram_windows_count_alike(const struct pp_world *world, int first);

/* The number of diagrams that a room needs. */
int pp_diagram_windows_diagram_count(const struct pp_world *world);

/* The face from which an opening is cut, for the title of its diagram. */
struct pp_board_face pp_diagram_windows_face(const struct pp_world *world,
                                             const struct pp_opening *opening);

/* Draws an opening as seen from the point and begins the sheet's window for it: its
 * line in the room file, corrections, distance, and an array with one piece for each
 * part of the drawing. On success the caller clears the drawing. */
enum pp_status pp_diagram_windows_begin(struct pp_board_window *window,
                                        struct pp_window_drawing *drawing,
                                        const struct pp_method *method,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 point, struct pp_error *err);

#endif
