/* gbxml_room.h - a space of a gbXML file as a room: its faces with their roles and names, and
 * its openings in them. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_ROOM_H
#define PP_FORMATS_GBXML_GBXML_ROOM_H

#include "formats/gbxml/gbxml_shell.h"

enum pp_gbxml_role { PP_GBXML_FLOOR, PP_GBXML_WALL, PP_GBXML_CEILING };

struct pp_gbxml_room_face {
    enum pp_gbxml_role role;
    char name[32];
    double reflectance; /* NAN: by its role */
    bool inner;         /* is another space behind it? */
};

struct pp_gbxml_room_opening {
    struct pp_gbxml_opening *opening; /* of the model */
    int face;
    struct pp_vec3
        *corners; /* in the face's plane, counter-clockwise seen from inside */
    int count;
};

/* Room in the axes of the building, unless a member says otherwise. */
struct pp_gbxml_room {
    struct pp_gbxml_shell shell;
    struct pp_gbxml_room_face *faces; /* of the shell */
    struct pp_gbxml_room_opening *openings;
    int opening_count;
    struct pp_vec3 origin; /* its own */
    double rotate_rad;     /* how far its own axes are turned; 0 but for boxes */
    bool is_box;           /* width, depth and height then */
    double width_m, depth_m, height_m;
};

/* Makes a room of a space: from the surfaces about it or, if those do not close, its
 * ShellGeometry. Notes the source used; *why as of pp_gbxml_shell_make. The room can be
 * cleared in any case. */
enum pp_status pp_gbxml_room_make(struct pp_gbxml_room *room, const char **why,
                                  struct pp_gbxml_model *model,
                                  const struct pp_gbxml_space *space,
                                  struct pp_mistakes *notes, struct pp_error *err);
void pp_gbxml_room_clear(struct pp_gbxml_room *room);

/* Converts a position to the room's own axes. */
struct pp_vec3 pp_gbxml_room_own(const struct pp_gbxml_room *room, struct pp_vec3 at);

/* Is the surface one of the space's, that is no column or shade? */
bool pp_gbxml_room_has(const struct pp_gbxml_surface *surface,
                       const struct pp_gbxml_space *space);

/* True if the surface is between that space and the outside. */
bool pp_gbxml_room_is_outer(const struct pp_gbxml_surface *surface);

#endif
