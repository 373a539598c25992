/* dxf_tags.h - a DXF file as a list of tags: group code and value, two lines each.
 * Inside model/mesh/ only.
 *
 * After the DXF reference of AutoCAD 2000: a group code defines the meaning of its
 * value; code 0 begins an entity or a section and gives its name.
 */
#ifndef PP_MODEL_MESH_DXF_TAGS_H
#define PP_MODEL_MESH_DXF_TAGS_H

#include "model/mesh/mesh_lines.h"

struct pp_dxf_tag {
    int code;
    int line;          /* line of the value */
    const char *value; /* without surrounding blanks; not owned */
};

/* Initialise with zeros; clear after use. Values point into the text of the lines. */
struct pp_dxf_tags {
    struct pp_dxf_tag *list;
    int count, space;
};

enum pp_status pp_dxf_tags_read(struct pp_dxf_tags *tags, struct pp_mesh_lines *lines,
                                struct pp_error *err);
void pp_dxf_tags_clear(struct pp_dxf_tags *tags);

/* Index of the next tag after `at` with code 0; the number of tags if there is none. */
int pp_dxf_tags_next(const struct pp_dxf_tags *tags, int at);

/* First tag of that code between `from` and `to`; NULL if there is none. */
const struct pp_dxf_tag *pp_dxf_tags_find(const struct pp_dxf_tags *tags, int from,
                                          int to, int code);

/* Number with that code between `from` and `to`, or `fallback`. PP_BAD_INPUT if the
 * value is not a number. */
enum pp_status pp_dxf_tags_number(double *number, const struct pp_dxf_tags *tags,
                                  int from, int to, int code, double fallback,
                                  const struct pp_mesh_lines *lines,
                                  struct pp_error *err);

#endif
