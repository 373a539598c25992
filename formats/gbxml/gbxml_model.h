/* gbxml_model.h - the parts of a gbXML file [GBXML] that matter for daylight, in
 * metres. Inside formats/gbxml/ only.
 *
 * Texts belong to the document, which must outlive the model; lists are owned.
 */
#ifndef PP_FORMATS_GBXML_GBXML_MODEL_H
#define PP_FORMATS_GBXML_GBXML_MODEL_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/geometry/vec.h"

struct pp_gbxml_polygon {
    struct pp_vec3 *corners;
    int count;
};

struct pp_gbxml_opening {
    int line;
    const char *name; /* NULL: none */
    struct pp_gbxml_polygon outline;
    double transmittance; /* visible, at normal incidence; NAN: the default */
    bool is_air;          /* an opening without glass */
    bool left_out;        /* not valid in the room file; already reported */
};

enum { PP_GBXML_NEIGHBOURS = 2 };

struct pp_gbxml_surface {
    int line;
    const char *type;                        /* "ExteriorWall"; empty if not given */
    const char *spaces[PP_GBXML_NEIGHBOURS]; /* ids of its spaces; NULL: none */
    struct pp_gbxml_polygon outline;
    double reflectance; /* visible, inside; NAN: the default */
    struct pp_gbxml_opening *openings;
    int opening_count;
    bool left_out; /* not valid in the room file; already reported */
};

struct pp_gbxml_space {
    int line;
    const char *id, *name;          /* name: for people; NULL: none */
    const char *type;               /* "OfficeEnclosed"; NULL: none */
    struct pp_gbxml_polygon *shell; /* polygons of its ShellGeometry */
    int shell_count;
    struct pp_gbxml_polygon floor; /* PlanarGeometry; empty: none */
    double area_m2, volume_m3;     /* as in the file; NAN: not given */
    bool left_out;                 /* its room is dropped; already reported */
};

struct pp_gbxml_model {
    const char *name;           /* name of the building; NULL: none */
    double latitude, longitude; /* degrees; NAN: not given */
    double north_deg;           /* compass bearing of +y */
    struct pp_gbxml_space *spaces;
    int space_count;
    struct pp_gbxml_surface *surfaces;
    int surface_count;
};

void pp_gbxml_model_clear(struct pp_gbxml_model *model);

/* True if the surface bounds the space; false for columns and shades. */
bool pp_gbxml_model_bounds(const struct pp_gbxml_surface *surface,
                           const struct pp_gbxml_space *space);

/* True if there is no second space behind the surface and its type is not an interior
 * one. */
bool pp_gbxml_model_is_outer(const struct pp_gbxml_surface *surface);

#endif
