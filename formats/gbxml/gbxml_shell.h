/* gbxml_shell.h - makes a closed envelope from the polygons around a space: corners
 * within a tolerance are welded, edges are split at corners on them, gaps are closed,
 * and all faces are turned inwards. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_SHELL_H
#define PP_FORMATS_GBXML_GBXML_SHELL_H

#include "formats/gbxml/gbxml_model.h"

struct pp_gbxml_face {
    int *corners; /* indices of corners, counter-clockwise seen from inside */
    int count;
    int from; /* index of its polygon; -1: added to close a hole */
};

struct pp_gbxml_shell {
    struct pp_vec3 *corners;
    int corner_count;
    struct pp_gbxml_face *faces;
    int face_count;
    int lacking;     /* number of faces added to close the shell */
    double weld_m;   /* tolerance within which corners were welded */
    double moved_m;  /* largest move of a corner */
    double moved_m3; /* sum over the polygons: area times mean move of the corners along
                   * the normal */
    double volume_m3; /* enclosed volume */
};

/* Corners nearer to each other than this (m) count as one: exporters round coordinates
 * to about a millimetre. */
#define PP_GBXML_SAME_M 2e-3

/* Makes a shell from `count` polygons, which are not changed. weld_m: tolerance,
 * PP_GBXML_SAME_M or more. *why: NULL, or the reason why the polygons give no shell, as
 * the end of a sentence about the space. The shell can be cleared even after a
 * failure. */
enum pp_status pp_gbxml_shell_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double weld_m, struct pp_error *err);
void pp_gbxml_shell_clear(struct pp_gbxml_shell *shell);

/* Area (m2) in plan of the faces that form the floor. */
double pp_gbxml_shell_floor_area(const struct pp_gbxml_shell *shell);

/* Area vector of the face: twice its area times its unit normal, which points
 * inwards. */
struct pp_vec3 pp_gbxml_shell_normal(const struct pp_gbxml_shell *shell, int face);

#endif
