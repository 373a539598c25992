/* atlas_mapping.h - maps of a method's error against one or two properties of rooms and
 * points, made from the table of an atlas. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_MAPPING_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_MAPPING_H

#include "model/results/atlas_map.h"
#include "studies/research/atlas/atlas_table.h"

/* Quantity against which errors are mapped. */
enum pp_atlas_mapping_kind {
    PP_MAP_DEPTH,       /* depth of the point, and ratio of the room's depth to its
                         * width */
    PP_MAP_ERC,         /* fraction of the externally reflected component in the direct
                         * light */
    PP_MAP_GROUND,      /* reflectance of the ground */
    PP_MAP_REFLECTANCE, /* mean reflectance inside */
    PP_MAP_OBSTRUCTION, /* angle of obstructions outside */
    PP_MAP_KINDS,
};

/* "depth", "erc", "ground", "reflectance", "obstruction". */
extern const char *const pp_atlas_mapping_names[PP_MAP_KINDS];

/* Makes the map of a method ("exact+bre") or of a column ("erc.exact"). The map of a
 * method shows its daylight factor or, if the method gives none, its component. The map
 * is at points; if the method gives only averages, it is of averages. A ratio counts if
 * the standard error of the simulated value is at most a tenth of that value. All
 * points of a room in a class together count as one. The map refers to the table.
 * PP_BAD_INPUT if the table has no such method, lacks the columns of the axes, or has
 * no values for the map. */
enum pp_status pp_atlas_mapping_of(struct pp_atlas_map *map,
                                   const struct pp_atlas_table *table,
                                   enum pp_atlas_mapping_kind kind, const char *method,
                                   struct pp_error *err);

#endif
