/* dxf_tags.h - a DXF file as its list of tags: group code and value, two lines each.
 * Inside model/mesh/ only.
 *
 * After the DXF reference of AutoCAD 2000: a group code defines the meaning of its
 * value; 0 begins an entity or a section and gives its name.
 */
#ifndef PP_MODEL_MESH_DXF_TAGS_H
#define PP_MODEL_MESH_DXF_TAGS_H

#include "model/mesh/mesh_lines.h"

struct pp_dxf_tag {
    int code;
    int line;          /* of the value */
    const char *value; /* blanks around it left out; not owned */
};

/* Begin with all zero; to be cleared. Values point into the lines' text. */
struct pp_dxf_tags {
    struct pp_dxf_tag *list;
    int count, space;
};

enum pp_status pp_dxf_tags_read(struct pp_dxf_tags *tags, struct pp_mesh_lines *lines,
                                struct pp_error *err);
void pp_dxf_tags_clear(struct pp_dxf_tags *tags);

/* The tag behind `at` that begins something (code 0), or the tags' count. */
int pp_dxf_tags_next(const struct pp_dxf_tags *tags, int at);

/* The tag of that code between `from` and `to`, the first; NULL: there is none. */
const struct pp_dxf_tag *pp_dxf_tags_find(const struct pp_dxf_tags *tags, int from,
                                          int to, int code);

/* The number that follows a code there, or `fallback`. PP_BAD_INPUT where the value is
 * no number. */
enum pp_status pp_dxf_tags_number(double *number, const struct pp_dxf_tags *tags,
                                  int from, int to, int code, double fallback,
                                  const struct pp_mesh_lines *lines,
                                  struct pp_error *err);

#endif
