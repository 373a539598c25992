/* mesh_dxf.c - reads the sections and blocks of the file, and chooses the entities to
 * read. */
#include "model/mesh/mesh_dxf.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "model/mesh/dxf_shapes.h"
#include "model/mesh/dxf_tags.h"

/* Limits on the nesting of blocks, and on the total number of inserted blocks. */
enum { DEPTH_MOST = 16, INSERTS_MOST = 100000 };

struct dxf {
    struct pp_mesh_triangles *mesh;
    struct pp_mesh_lines *lines;
    struct pp_dxf_tags tags;
    int inserts;
};

static bool is(const struct pp_dxf_tag *tag, const char *name)
{
    return strcmp(tag->value, name) == 0;
}

/* Range of the section's tags without its name; false if there is no such section. */
static bool find_section(int range[2], const struct dxf *dxf, const char *name)
{
    const struct pp_dxf_tag *list = dxf->tags.list;
    int count = dxf->tags.count;
    for (int i = 0; i + 1 < count; i++) {
        if (list[i].code != 0 || !is(&list[i], "SECTION") || !is(&list[i + 1], name))
            continue;
        range[0] = range[1] = i + 2;
        while (range[1] < count
               && !(list[range[1]].code == 0 && is(&list[range[1]], "ENDSEC")))
            range[1]++;
        return true;
    }
    return false;
}

/* ---- The unit ---- */

/* Metres per unit of $INSUNITS; 0: no unit. */
static double unit_of(int insunits)
{
    static const double units[] = {0.0,  0.0254, 0.3048,  1609.344, 1e-3,   1e-2,
                                   1.0,  1e3,    2.54e-8, 2.54e-5,  0.9144, 1e-10,
                                   1e-9, 1e-6,   0.1,     10.0,     100.0};
    bool known = insunits > 0 && insunits < (int)(sizeof units / sizeof *units);
    return known ? units[insunits] : 0.0;
}

static enum pp_status read_unit(struct dxf *dxf, struct pp_error *err)
{
    int range[2];
    if (!find_section(range, dxf, "HEADER"))
        return PP_OK;
    for (int i = range[0]; i + 1 < range[1]; i++) {
        double value;
        if (dxf->tags.list[i].code != 9 || !is(&dxf->tags.list[i], "$INSUNITS"))
            continue;
        enum pp_status status = pp_dxf_tags_number(&value, &dxf->tags, i + 1, i + 2, 70,
                                                   0.0, dxf->lines, err);
        if (status == PP_OK && value >= 0.0 && value < 100.0)
            dxf->mesh->unit_m = unit_of((int)value);
        return status;
    }
    return PP_OK;
}

/* ---- Entities ---- */

static enum pp_status read_entities(struct dxf *dxf, int from, int to,
                                    const struct pp_dxf_move *move, int depth,
                                    struct pp_error *err);

/* Rejects a block whose contents are in another file (bit 4 or 8 of group 70). */
static enum pp_status check_own(const struct pp_dxf_entity *block, const char *name,
                                struct pp_error *err)
{
    const struct pp_dxf_tag *path =
        pp_dxf_tags_find(block->tags, block->from, block->to, 1);
    char shown[160], other[160];
    double flags;
    enum pp_status status = pp_dxf_tags_number(&flags, block->tags, block->from,
                                               block->to, 70, 0.0, block->lines, err);
    bool outside = flags >= 0.0 && flags < 256.0 && ((int)flags & (4 | 8)) != 0;
    if (status != PP_OK || !outside)
        return status;
    return pp_mesh_lines_fail(
        block->lines, block->tags->list[block->from].line, err,
        "BLOCK: \"%s\" is an external reference to the drawing \"%s\"; expected the "
        "drawing bound into this file",
        pp_text_excerpt(shown, sizeof shown, name),
        pp_text_excerpt(other, sizeof other, path ? path->value : ""));
}

/* Entities of the block of that name; *found is false if there is none. *base: its
 * origin. */
static enum pp_status find_block(int range[2], struct pp_vec3 *base, bool *found,
                                 const struct dxf *dxf, const char *name,
                                 struct pp_error *err)
{
    int blocks[2];
    *found = false;
    if (!find_section(blocks, dxf, "BLOCKS"))
        return PP_OK;
    for (int i = blocks[0]; i < blocks[1]; i = pp_dxf_tags_next(&dxf->tags, i)) {
        int next = pp_dxf_tags_next(&dxf->tags, i);
        const struct pp_dxf_tag *own = pp_dxf_tags_find(&dxf->tags, i, next, 2);
        if (!is(&dxf->tags.list[i], "BLOCK") || !own || strcmp(own->value, name) != 0)
            continue;
        *found = true;
        range[0] = range[1] = next;
        while (range[1] < blocks[1] && !is(&dxf->tags.list[range[1]], "ENDBLK"))
            range[1] = pp_dxf_tags_next(&dxf->tags, range[1]);
        struct pp_dxf_entity block = {
            .tags = &dxf->tags, .lines = dxf->lines, .from = i, .to = next};
        enum pp_status status = check_own(&block, name, err);
        return status == PP_OK ? pp_dxf_shapes_point(base, &block, 10, err) : status;
    }
    return PP_OK;
}

/* Transformation from the block's coordinates to those of the insert. steps: if the
 * insert repeats the block, the offsets from column to column and from row to row. */
static enum pp_status move_of(struct pp_dxf_move *move, struct pp_vec3 steps[2],
                              const struct pp_dxf_entity *e, struct pp_vec3 base,
                              struct pp_error *err)
{
    struct pp_vec3 at, scale;
    double spacing[2];
    double *scales[3] = {&scale.x, &scale.y, &scale.z}, degrees;
    struct pp_dxf_move own;
    enum pp_status status = pp_dxf_shapes_axes(&own, e, err);
    if (status == PP_OK)
        status = pp_dxf_shapes_point(&at, e, 10, err);
    for (int k = 0; k < 3 && status == PP_OK; k++)
        status = pp_dxf_tags_number(scales[k], e->tags, e->from, e->to, 41 + k, 1.0,
                                    e->lines, err);
    if (status == PP_OK)
        status = pp_dxf_tags_number(&degrees, e->tags, e->from, e->to, 50, 0.0,
                                    e->lines, err);
    for (int k = 0; k < 2 && status == PP_OK; k++)
        status = pp_dxf_tags_number(&spacing[k], e->tags, e->from, e->to, 44 + k, 0.0,
                                    e->lines, err);
    if (status != PP_OK)
        return status;
    double c = cos(degrees * PP_RAD), s = sin(degrees * PP_RAD);
    const struct pp_vec3 axes[3] = {{c * scale.x, s * scale.x, 0.0},
                                    {-s * scale.y, c * scale.y, 0.0},
                                    {0.0, 0.0, scale.z}};
    struct pp_dxf_move turned = {.origin = {0.0, 0.0, 0.0}};
    for (int k = 0; k < 3; k++)
        turned.axes[k] = pp_dxf_shapes_moved(&own, axes[k]);
    turned.origin =
        pp_vec_sub(pp_dxf_shapes_moved(&own, at), pp_dxf_shapes_moved(&turned, base));
    /* Converts to the file's coordinates. */
    struct pp_dxf_move level = *e->move;
    level.origin = pp_vec(0.0, 0.0, 0.0);
    move->origin = pp_dxf_shapes_moved(e->move, turned.origin);
    for (int k = 0; k < 3; k++)
        move->axes[k] = pp_dxf_shapes_moved(&level, turned.axes[k]);
    const struct pp_vec3 ways[2] = {{c * spacing[0], s * spacing[0], 0.0},
                                    {-s * spacing[1], c * spacing[1], 0.0}};
    for (int k = 0; k < 2; k++)
        steps[k] = pp_dxf_shapes_moved(&level, pp_dxf_shapes_moved(&own, ways[k]));
    return PP_OK;
}

static enum pp_status read_insert(struct dxf *dxf, const struct pp_dxf_entity *e,
                                  int depth, struct pp_error *err)
{
    int line = dxf->tags.list[e->from].line, range[2] = {0, 0};
    const struct pp_dxf_tag *name = pp_dxf_tags_find(&dxf->tags, e->from, e->to, 2);
    char shown[160] = "";
    double columns, rows;
    bool found = false;
    struct pp_vec3 base, steps[2];
    struct pp_dxf_move move;
    enum pp_status status = pp_dxf_tags_number(&columns, &dxf->tags, e->from, e->to, 70,
                                               1.0, dxf->lines, err);
    if (status == PP_OK)
        status = pp_dxf_tags_number(&rows, &dxf->tags, e->from, e->to, 71, 1.0,
                                    dxf->lines, err);
    if (status == PP_OK && name) {
        pp_text_excerpt(shown, sizeof shown, name->value);
        status = find_block(range, &base, &found, dxf, name->value, err);
    }
    if (status != PP_OK)
        return status;
    if (!found)
        return pp_mesh_lines_fail(
            dxf->lines, line, err,
            "INSERT: there is no block \"%s\" in the file; expected a block defined "
            "in its BLOCKS section",
            shown);
    columns = fmax(floor(columns), 1.0), rows = fmax(floor(rows), 1.0);
    if (depth >= DEPTH_MOST || !(columns * rows <= INSERTS_MOST - dxf->inserts))
        return pp_mesh_lines_fail(dxf->lines, line, err,
                                  "INSERT: blocks are nested too deeply or inserted "
                                  "too often, first in \"%s\"; expected at most %d "
                                  "levels, and %d insertions in all",
                                  shown, DEPTH_MOST, INSERTS_MOST);
    dxf->inserts += (int)(columns * rows);
    status = move_of(&move, steps, e, base, err);
    for (double row = 0.0; row < rows && status == PP_OK; row++)
        for (double column = 0.0; column < columns && status == PP_OK; column++) {
            struct pp_dxf_move copy = move;
            copy.origin = pp_vec_along(copy.origin, column, steps[0]);
            copy.origin = pp_vec_along(copy.origin, row, steps[1]);
            status = read_entities(dxf, range[0], range[1], &copy, depth + 1, err);
        }
    return status;
}

/* Rejects surfaces that cannot be read, including lines extruded by a thickness (group
 * 39). */
static enum pp_status refuse_dxf_entity(const struct pp_dxf_entity *e,
                                        struct pp_error *err)
{
    static const char *const surfaces[] = {"3DSOLID",          "BODY",
                                           "REGION",           "SURFACE",
                                           "PLANESURFACE",     "EXTRUDEDSURFACE",
                                           "LOFTEDSURFACE",    "REVOLVEDSURFACE",
                                           "SWEPTSURFACE",     "NURBSURFACE",
                                           "ACAD_PROXY_ENTITY"};
    static const char *const raised[] = {"LINE", "ARC", "CIRCLE"};
    const struct pp_dxf_tag *tag = &e->tags->list[e->from];
    double thickness;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++)
        if (is(tag, surfaces[i]))
            return pp_mesh_lines_fail(
                e->lines, tag->line, err,
                "%s: this entity is not supported; expected 3DFACE, polyface meshes, "
                "or polylines with a thickness",
                surfaces[i]);
    for (size_t i = 0; i < sizeof raised / sizeof *raised; i++) {
        if (!is(tag, raised[i]))
            continue;
        enum pp_status status = pp_dxf_tags_number(&thickness, e->tags, e->from, e->to,
                                                   39, 0.0, e->lines, err);
        if (status == PP_OK && thickness != 0.0)
            status = pp_mesh_lines_fail(
                e->lines, tag->line, err,
                "%s: a thickness is not supported here; expected a thickness on "
                "polylines only",
                raised[i]);
        return status;
    }
    return PP_OK;
}

static enum pp_status read_entity(struct dxf *dxf, struct pp_dxf_entity *e, int depth,
                                  struct pp_error *err)
{
    const struct pp_dxf_tag *tag = &dxf->tags.list[e->from];
    if (is(tag, "3DFACE"))
        return pp_dxf_shapes_face(e, err);
    if (is(tag, "LWPOLYLINE"))
        return pp_dxf_shapes_lwpolyline(e, err);
    if (is(tag, "POLYLINE"))
        return pp_dxf_shapes_polyline(e, err);
    if (is(tag, "MESH"))
        return pp_dxf_shapes_mesh(e, err);
    if (is(tag, "SOLID") || is(tag, "TRACE"))
        return pp_dxf_shapes_solid(e, err);
    if (is(tag, "INSERT"))
        return read_insert(dxf, e, depth, err);
    return refuse_dxf_entity(e, err);
}

/* End of the entity; for a polyline, after its vertices. */
static int end_of(const struct dxf *dxf, int at, int to)
{
    bool has_parts = is(&dxf->tags.list[at], "POLYLINE");
    int next = pp_dxf_tags_next(&dxf->tags, at);
    while (has_parts && next < to && is(&dxf->tags.list[next], "VERTEX"))
        next = pp_dxf_tags_next(&dxf->tags, next);
    return next < to ? next : to;
}

static enum pp_status read_entities(struct dxf *dxf, int from, int to,
                                    const struct pp_dxf_move *move, int depth,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int at = from; at < to && status == PP_OK;) {
        struct pp_dxf_entity entity = {.mesh = dxf->mesh,
                                       .tags = &dxf->tags,
                                       .lines = dxf->lines,
                                       .move = move,
                                       .from = at,
                                       .to = end_of(dxf, at, to)};
        if (dxf->tags.list[at].code == 0)
            status = read_entity(dxf, &entity, depth, err);
        at = entity.to;
    }
    return status;
}

static enum pp_status read_file(struct dxf *dxf, struct pp_error *err)
{
    static const struct pp_dxf_move none = {
        .axes = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    int range[2];
    enum pp_status status = read_unit(dxf, err);
    if (status != PP_OK)
        return status;
    if (!find_section(range, dxf, "ENTITIES"))
        return pp_mesh_lines_fail(dxf->lines, dxf->lines->line, err,
                                  "the file has no ENTITIES section; expected one");
    status = read_entities(dxf, range[0], range[1], &none, 0, err);
    if (status == PP_OK && dxf->mesh->triangle_count == 0)
        status =
            pp_mesh_lines_fail(dxf->lines, dxf->lines->line, err,
                               "the file has no surfaces; expected 3DFACE, polyface "
                               "meshes, or polylines with a thickness (group 39)");
    return status;
}

enum pp_status pp_mesh_dxf_read(struct pp_mesh_triangles *mesh,
                                struct pp_mesh_lines *lines, struct pp_error *err)
{
    static const char binary[] = "AutoCAD Binary DXF";
    struct dxf dxf = {.mesh = mesh, .lines = lines};
    if (lines->left >= sizeof binary
        && memcmp(lines->text, binary, sizeof binary - 1) == 0)
        return pp_mesh_lines_fail(
            lines, 1, err,
            "this is a binary DXF file; expected a text (ASCII) DXF file");
    enum pp_status status = pp_dxf_tags_read(&dxf.tags, lines, err);
    if (status == PP_OK)
        status = read_file(&dxf, err);
    pp_dxf_tags_clear(&dxf.tags);
    return status;
}
