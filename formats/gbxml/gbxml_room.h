/* gbxml_room.h - a space of a gbXML file as a room: its faces with roles and names, and
 * their openings. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_ROOM_H
#define PP_FORMATS_GBXML_GBXML_ROOM_H

#include "formats/gbxml/gbxml_shell.h"
#include "model/base/mistakes.h"
#include "model/geometry/clipper.h"

enum pp_gbxml_role { PP_GBXML_FLOOR, PP_GBXML_WALL, PP_GBXML_CEILING };

struct pp_gbxml_room_face {
    enum pp_gbxml_role role;
    char name[32];
    double reflectance; /* NAN: the default of its role */
    bool inner;         /* true if another space lies behind it */
};

struct pp_gbxml_room_opening {
    struct pp_gbxml_opening *opening; /* not owned */
    int face;                         /* face index; an opening may be in several */
    struct pp_vec3
        *corners; /* in the face's plane, counter-clockwise seen from inside */
    int count;
};

/* A room. Coordinates are in the building's axes unless a member says otherwise. */
struct pp_gbxml_room {
    struct pp_gbxml_shell shell;
    bool by_surfaces;                 /* faces made from the surfaces of the space */
    struct pp_gbxml_room_face *faces; /* one per face of the shell */
    struct pp_gbxml_room_opening *openings;
    int opening_count;
    struct pp_vec3 origin; /* origin of the room's own coordinates */
    double rotate_rad;     /* rotation of the room's own axes; 0 unless a box */
    bool is_box;           /* a box of width, depth and height */
    double width_m, depth_m, height_m;
    double plane_m, spacing_m; /* working plane and grid; NAN: default */
};

/* Finds the room's envelope (gbxml_envelope.h) and notes its source; *why as in
 * pp_gbxml_shell_make. The room can be cleared even after a failure. */
enum pp_status pp_gbxml_room_begin(struct pp_gbxml_room *room, const char **why,
                                   struct pp_gbxml_model *model,
                                   const struct pp_gbxml_space *space,
                                   struct pp_clipper *clipper,
                                   struct pp_mistakes *notes, struct pp_error *err);

/* Divides non-planar faces into triangles; sets roles, names and finishes of all faces;
 * tests for a box; fits working plane and grid. */
enum pp_status pp_gbxml_room_finish(struct pp_gbxml_room *room,
                                    struct pp_gbxml_model *model,
                                    const struct pp_gbxml_space *space,
                                    struct pp_mistakes *notes, struct pp_error *err);
void pp_gbxml_room_clear(struct pp_gbxml_room *room);

/* Converts a position to the room's own axes. */
struct pp_vec3 pp_gbxml_room_own(const struct pp_gbxml_room *room, struct pp_vec3 at);

#endif
