/* gbxml_shell.h - makes a closed envelope of the polygons about a space: corners within
 * a tolerance are welded, edges are split at corners on them, gaps are closed, and all
 * faces are turned inwards. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_SHELL_H
#define PP_FORMATS_GBXML_GBXML_SHELL_H

#include "formats/gbxml/gbxml_model.h"

struct pp_gbxml_face {
    int *corners; /* of the shell's list, counter-clockwise seen from inside */
    int count;
    int from; /* which polygon it is; -1: it closes the shell where one lacks */
};

struct pp_gbxml_shell {
    struct pp_vec3 *corners;
    int corner_count;
    struct pp_gbxml_face *faces;
    int face_count;
    int lacking;    /* how many faces were added to close it */
    double weld_m;  /* the tolerance */
    double moved_m; /* farthest that a corner was moved */
    double
        moved_m3; /* each polygon's area times its corners' mean move along the normal */
    double volume_m3; /* of the closed shell */
};

/* Corners nearer than this are the same: exports round to a millimetre or so. Metres. */
#define PP_GBXML_SAME_M 2e-3

/* Makes a shell of `count` polygons, which are left as they are; weld_m: the tolerance,
 * PP_GBXML_SAME_M or more. *why: NULL, or the reason why none comes of them, as the end
 * of a sentence about the space. The shell can be cleared whatever comes. */
enum pp_status pp_gbxml_shell_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double weld_m, struct pp_error *err);
void pp_gbxml_shell_clear(struct pp_gbxml_shell *shell);

/* Area (m2) of the faces that people stand on, seen from above. */
double pp_gbxml_shell_floor_area(const struct pp_gbxml_shell *shell);

/* Twice the face's area times its unit normal, which looks inwards. */
struct pp_vec3 pp_gbxml_shell_normal(const struct pp_gbxml_shell *shell, int face);

#endif
